#include "workpiece/initial_values.hpp"
#include "base/error.hpp"
#include "base/sentence.hpp"
#include "workpiece/point_fields.hpp"
#include <cmath>

namespace burnish {
namespace {

constexpr double ON_SURFACE = 1e-9; // over the yield stress: rounding

template <int Dim>
void require_initial(const Workpiece<Dim>& body, const Eigen::VectorXd& values, const char* where) {
  if (body.state_old().dt > 0)
    fail(where, "the body has a step behind it, expected one before its first step");
  require(values.size() == body.discretization().num_points(), where, "number of values", values.size(),
          std::to_string(body.discretization().num_points()).c_str());
  for (Eigen::Index p = 0; p < values.size(); ++p)
    if (!std::isfinite(values[p]))
      fail(where, sentence("value ", p, " = ", values[p], ", expected finite numbers"));
}

} // namespace

template <int Dim> OutOfBalance out_of_balance(const Workpiece<Dim>& body, const std::vector<char>& fixed) {
  OutOfBalance found;
  const Eigen::VectorXd force = body.internal_force();
  for (Eigen::Index d = 0; d < force.size(); ++d) {
    found.largest = std::max(found.largest, std::abs(force[d]));
    if (!fixed[static_cast<std::size_t>(d)])
      found.unbalanced = std::max(found.unbalanced, std::abs(force[d]));
  }
  return found;
}

template <int Dim>
void set_initial_stress(Workpiece<Dim>& body, const std::vector<Eigen::VectorXd>& stress, const char* where) {
  require(stress.size() == num_stress<Dim>, where, "number of components", stress.size(),
          std::to_string(num_stress<Dim>).c_str());
  WorkpieceState<Dim> state = body.state_old();
  for (std::size_t k = 0; k < stress.size(); ++k) {
    require_initial(body, stress[k], where);
    for (Eigen::Index p = 0; p < stress[k].size(); ++p)
      state.stress[static_cast<std::size_t>(p) * num_stress<Dim> + k] = stress[k][p];
  }
  for (int p = 0; p < body.discretization().num_points(); ++p) {
    const PointState<Dim> at = point_state(state, p);
    const double distance = body.law().yield_distance(at.stress, at.internal);
    if (!(distance > ON_SURFACE)) continue;
    const Vector<Dim> x =
        Eigen::Map<const Vector<Dim>>(&body.discretization().point[static_cast<std::size_t>(Dim) * p]);
    fail(where, sentence("the stress of point ", p, " at ", place_text(x), " is ", 1 + distance,
                         " times the yield stress, expected at most 1"));
  }
  body.set_state(state);
}

template <int Dim>
void set_initial_variable(Workpiece<Dim>& body, const std::string& name, int component,
                          const Eigen::VectorXd& values, const char* where) {
  require_initial(body, values, where);
  const auto place = static_cast<std::size_t>(body.law().internal_place(name, component, where));
  const bool strain = name == "plastic_strain_eq";
  WorkpieceState<Dim> state = body.state_old();
  for (Eigen::Index p = 0; p < values.size(); ++p) {
    require(!strain || values[p] >= 0, where, "plastic_strain_eq", values[p], ">= 0");
    state.internal[static_cast<std::size_t>(p) * body.law().internal_variables().size() + place] = values[p];
  }
  body.set_state(state);
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template OutOfBalance out_of_balance<Dim>(const Workpiece<Dim>&, const std::vector<char>&);                \
  template void set_initial_stress<Dim>(Workpiece<Dim>&, const std::vector<Eigen::VectorXd>&, const char*);  \
  template void set_initial_variable<Dim>(Workpiece<Dim>&, const std::string&, int, const Eigen::VectorXd&,  \
                                          const char*);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish
