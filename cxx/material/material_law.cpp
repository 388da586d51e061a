#include "material/material_law.hpp"

namespace burnish {

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
