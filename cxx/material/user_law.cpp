#include "material/user_law.hpp"
#include "material/step_kinematics_in_space.hpp"
#include <algorithm>
#include <sstream>

namespace burnish {
namespace {

std::vector<InternalVariable> variables(const std::vector<std::string>& names) {
  std::vector<InternalVariable> list{{"plastic_strain_eq", "ep", "-", TensorKind::SCALAR, 0}};
  for (const std::string& name : names) list.push_back({name, name, "", TensorKind::SCALAR, 0});
  return list;
}

} // namespace

template <int Dim>
UserLaw<Dim>::UserLaw(const std::vector<std::string>& internal, bool small_strain)
    : MaterialLaw<Dim>("user-defined", variables(internal)), m_small_strain(small_strain) {}

template <int Dim>
PointResult UserLaw<Dim>::update(const PointStep<Dim>& step, PointTrial&, PointUpdate<Dim>& now) const {
  now.stress = step.old.stress;
  std::copy_n(step.old.internal, this->internal_variables().size(), now.internal);
  now.strain_increment = increments(step).y.template head<num_stress<Dim>>();
  return {};
}

template <int Dim>
PiolaTangent<Dim> UserLaw<Dim>::tangent(TangentKind, const PointStep<Dim>&, const PointTrial&,
                                        const PointState<Dim>&) const {
  return PiolaTangent<Dim>::Zero();
}

template <int Dim> StepIncrements<Dim> UserLaw<Dim>::increments(const PointStep<Dim>& step) const {
  return increments_of(
      step_kinematics(step.old.F, step.F, step.options.strain_frame,
                      m_small_strain ? CorotationalRate::SMALL_STRAIN : CorotationalRate::JAUMANN));
}

std::vector<std::string> internal_names(const std::string& list) {
  std::vector<std::string> names;
  std::istringstream text(list);
  for (std::string name; std::getline(text, name, ',');) {
    const std::size_t first = name.find_first_not_of(" \t"), last = name.find_last_not_of(" \t");
    names.push_back(first == std::string::npos ? "" : name.substr(first, last - first + 1));
  }
  return names;
}

template class UserLaw<2>;
template class UserLaw<3>;

} // namespace burnish
