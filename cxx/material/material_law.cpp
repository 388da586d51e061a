#include "material/material_law.hpp"
#include "base/error.hpp"

namespace burnish {

template <int Dim>
PointResult MaterialLaw<Dim>::update_one(const RangeStep<Dim>& step, int k,
                                         const RangeUpdate<Dim>& now) const {
  const std::size_t p = k;
  PointUpdate<Dim> found;
  found.internal = now.internal + p * step.num_internal;
  const PointResult result = update(step.point(k), now.trial[p], found);
  if (result.status != UpdateStatus::OK) return result;
  Eigen::Map<Stress<Dim>>(now.stress + p * num_stress<Dim>) = found.stress;
  Eigen::Map<Stress<Dim>>(now.strain_increment + p * num_stress<Dim>) = found.strain_increment;
  now.plastic[p] = found.plastic;
  return result;
}

template <int Dim>
RangeResult MaterialLaw<Dim>::update_range(const RangeStep<Dim>& step, const RangeUpdate<Dim>& now) const {
  for (int k = 0; k < step.size; ++k) {
    const PointResult result = update_one(step, k, now);
    if (result.status != UpdateStatus::OK) return {result, k};
  }
  return {};
}

template <int Dim>
int MaterialLaw<Dim>::internal_place(const std::string& variable, int component, const char* where) const {
  const int k = m_internal.find(variable);
  if (k < 0)
    fail(where, "law \"" + m_name + "\" has no internal variable \"" + variable + "\", expected one of " +
                    m_internal.names());
  const int n = num_components<Dim>(m_internal.list()[k].kind);
  require(component >= 0 && component < n, where, "component", component,
          ("0.." + std::to_string(n - 1)).c_str());
  return m_internal.offset(k) + component;
}

template <int Dim> double MaterialLaw<Dim>::modulus(const std::string& name) const {
  const auto known = moduli();
  std::string list;
  for (const auto& [one, value] : known) list += (list.empty() ? "" : ", ") + one;
  if (known.count(name) == 0)
    fail("modulus", "law \"" + m_name + "\" has no modulus \"" + name + "\", expected one of " +
                        (list.empty() ? "none" : list));
  return known.at(name);
}

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
