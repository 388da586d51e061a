// The workpiece with a user-defined law.
#include "base/error.hpp"
#include "workpiece/workpiece.hpp"

namespace burnish {

template <int Dim> void Workpiece<Dim>::set_user_defined(bool user_defined) {
  if (!user_defined && !m_law->has_moduli())
    fail("Workpiece::set_user_defined", "law \"" + m_law->name() + "\" has no stress of its own");
  if (user_defined && tracks_integrity())
    fail("Workpiece::set_user_defined",
         "damage is defined, expected a law of the core: the stress that a script keeps "
         "cannot be forgotten");
  if (user_defined && !m_user) m_user.emplace(m_discretization);
  if (!user_defined) m_user.reset();
}

template <int Dim> UserPoints<Dim>& Workpiece<Dim>::given(const char* where) {
  if (!m_user) fail(where, "the law of this material is not user-defined, nothing can be given");
  if (!m_updated) fail(where, "there was no update since the last accepted state, call update first");
  return *m_user;
}

template <int Dim>
void Workpiece<Dim>::give_stress(int component, const PointValues& values, const char* where) {
  given(where).stress(component, values, m_state, where);
}
template <int Dim>
void Workpiece<Dim>::give_piola(int component, const PointValues& values, const char* where) {
  given(where).piola(component, values, m_state, where);
}
template <int Dim>
void Workpiece<Dim>::give_moduli(int row, int column, const PointValues& values, const char* where) {
  given(where).moduli(row, column, values, where);
}
template <int Dim>
void Workpiece<Dim>::give_jacobian(int row, int column, const PointValues& values, const char* where) {
  given(where).jacobian(row, column, values, where);
}

template <int Dim>
void Workpiece<Dim>::give_internal(const std::string& name, int component, const PointValues& values,
                                   const char* where) {
  given(where).check(values, "internal variable " + name, where);
  const int offset = offset_of(name, component, where);
  const bool flow = name == "plastic_strain_eq";
  for (Eigen::Index p = 0; p < values.size(); ++p) {
    const std::size_t place = static_cast<std::size_t>(p) * m_num_internal + offset;
    m_state.internal[place] = values[p];
    if (flow) m_state.plastic[p] = values[p] > m_state_old.internal[place];
  }
}

template <int Dim> RangeResult Workpiece<Dim>::move_points(int first, const RangeStep<Dim>& step) {
  for (int k = 0; k < step.size; ++k) {
    const PointStep<Dim> one = step.point(k);
    const Gradient<Dim> F_mid = 0.5 * (one.old.F + one.F);
    const PointResult result = determinant_result(determinant(F_mid));
    if (result.status != UpdateStatus::OK) return {result, k};
    const std::size_t p = first + k;
    Eigen::Map<Stress<Dim>>(m_state.strain_increment.data() + p * num_stress<Dim>) =
        m_law->increments(one).y.template head<num_stress<Dim>>();
    m_state.plastic[p] = 0;
  }
  return {};
}

// A = dP/dF as given, or from d tau/dy by the kinematics of the step.
template <int Dim> PiolaTangent<Dim> Workpiece<Dim>::user_moduli(int point) const {
  if (!m_user->has_jacobian()) return m_user->moduli_of(point);
  const PointState<Dim> now = point_now(point);
  const StressByF<Dim> by_F = m_user->jacobian_of(point) * m_law->increments(point_step(point)).by_F;
  return piola_tangent<Dim>(by_F, now.stress, inverse(Gradient<Dim>(now.F)));
}

// clang-format off
#define BURNISH_USER_DEFINED(Dim)                                                                                      \
  template void Workpiece<Dim>::set_user_defined(bool);                                                                \
  template UserPoints<Dim>& Workpiece<Dim>::given(const char*);                                                        \
  template void Workpiece<Dim>::give_stress(int, const PointValues&, const char*);                                     \
  template void Workpiece<Dim>::give_piola(int, const PointValues&, const char*);                                      \
  template void Workpiece<Dim>::give_moduli(int, int, const PointValues&, const char*);                                \
  template void Workpiece<Dim>::give_jacobian(int, int, const PointValues&, const char*);                              \
  template void Workpiece<Dim>::give_internal(const std::string&, int, const PointValues&, const char*);               \
  template RangeResult Workpiece<Dim>::move_points(int, const RangeStep<Dim>&);                                        \
  template PiolaTangent<Dim> Workpiece<Dim>::user_moduli(int) const;
// clang-format on
BURNISH_USER_DEFINED(2)
BURNISH_USER_DEFINED(3)

} // namespace burnish
