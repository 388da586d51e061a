#include "material/material_law.hpp"

namespace burnish {

template <int Dim> StepIncrements<Dim> MaterialLaw<Dim>::increments(const PointStep<Dim>&) const {
  StepIncrements<Dim> none;
  none.y.setZero();
  none.by_F.setZero();
  return none;
}
template <int Dim> YieldStress MaterialLaw<Dim>::yield_stress(double) const {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  return {none, none};
}
template <int Dim> double MaterialLaw<Dim>::yield_distance(const Stress<Dim>&, const double*) const {
  return -1;
}
template <int Dim> bool MaterialLaw<Dim>::loads(const PointState<Dim>&, const Stress<Dim>&) const {
  return false;
}
template <int Dim> double MaterialLaw<Dim>::yield_fraction(const PointStep<Dim>&, double, double) const {
  return NEVER;
}
template <int Dim> PointLoading MaterialLaw<Dim>::loading(const PointStep<Dim>&) const { return {}; }

template class MaterialLaw<2>;
template class MaterialLaw<3>;

} // namespace burnish
