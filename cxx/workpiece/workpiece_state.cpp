#include "workpiece/workpiece_state.hpp"
#include "base/error.hpp"
#include <cmath>

namespace burnish {
namespace {

void check_array(const char* where, const char* name, const double* data, std::size_t size,
                 std::size_t expected) {
  const std::string size_name = std::string("size of ") + name;
  require(size == expected, where, size_name.c_str(), size, std::to_string(expected).c_str());
  for (std::size_t k = 0; k < size; ++k)
    require(std::isfinite(data[k]), where, name, data[k], "finite numbers");
}

} // namespace

template <int Dim>
WorkpieceState<Dim> initial_state(const Discretization<Dim>& mesh, const InternalVariables<Dim>& internal) {
  WorkpieceState<Dim> state;
  const std::size_t points = mesh.num_points();
  state.displacement = Eigen::VectorXd::Zero(mesh.num_dofs());
  const Gradient<Dim> F = undeformed<Dim>();
  const std::vector<double> start = internal.initial();
  state.F.reserve(points * num_gradient<Dim>);
  state.internal.reserve(points * start.size());
  for (std::size_t p = 0; p < points; ++p) {
    state.F.insert(state.F.end(), F.begin(), F.end());
    state.internal.insert(state.internal.end(), start.begin(), start.end());
  }
  state.stress.assign(points * num_stress<Dim>, 0.);
  state.strain_increment = state.stress;
  state.plastic.assign(points, 0);
  return state;
}

template <int Dim>
void require_valid(const WorkpieceState<Dim>& state, const Discretization<Dim>& mesh,
                   const InternalVariables<Dim>& internal, const char* where) {
  const std::size_t points = mesh.num_points(), stresses = points * num_stress<Dim>;
  const auto check = [&](const char* name, const auto& array, std::size_t expected) {
    check_array(where, name, array.data(), array.size(), expected);
  };
  check("displacement", state.displacement, mesh.num_dofs());
  check("F", state.F, points * num_gradient<Dim>);
  check("stress", state.stress, stresses);
  check("internal", state.internal, points * internal.size());
  check("strain_increment", state.strain_increment, stresses);
  require(state.plastic.size() == points, where, "size of plastic", state.plastic.size(),
          std::to_string(points).c_str());
  for (std::size_t p = 0; p < points; ++p) {
    const Gradient<Dim> F = Eigen::Map<const Gradient<Dim>>(state.F.data() + p * num_gradient<Dim>);
    require(determinant(F) > 0, where, "det F", determinant(F), "> 0");
  }
  const std::size_t tracked = state.integrity.empty() ? 0 : points;
  check("integrity", state.integrity, tracked);
  check("integrity_rate", state.integrity_rate, tracked);
  check("integrity_goal", state.integrity_goal, tracked);
  for (const std::vector<double>* values : {&state.integrity, &state.integrity_goal})
    for (const double w : *values) require(w > 0 && w <= 1, where, "integrity", w, "0 < integrity <= 1");
  require(state.dt >= 0 && std::isfinite(state.dt), where, "dt", state.dt, "finite >= 0");
}

template WorkpieceState<2> initial_state<2>(const Discretization<2>&, const InternalVariables<2>&);
template WorkpieceState<3> initial_state<3>(const Discretization<3>&, const InternalVariables<3>&);
template void require_valid<2>(const WorkpieceState<2>&, const Discretization<2>&,
                               const InternalVariables<2>&, const char*);
template void require_valid<3>(const WorkpieceState<3>&, const Discretization<3>&,
                               const InternalVariables<3>&, const char*);

} // namespace burnish
