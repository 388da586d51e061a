#pragma once
// The rate law, METHOD.md (1.6): corotational rate of the Kirchhoff stress = D:d, and its forward Euler step.
#include "material/j2/parameters.hpp"

namespace burnish {

/// A stress counts as on the surface from this fraction of sigma_y on: for rounding only.
inline constexpr double YIELD_FRACTION = 1 - 1e-9;

/// Loading test of METHOD.md (1.6): q >= sigma_y(ep) and s:d > 0. With a back stress s is that less X, here and below.
/// @param yielded the point is on the surface by an event, whatever q says within the event's tolerance
template <int Dim>
bool loads(const J2Parameters& material, const Stress<Dim>& s, double plastic_strain_eq, const Stress<Dim>& d,
           bool yielded = false) {
  if (yielded) return contract<Dim>(s, d) > 0;
  const double yield = YIELD_FRACTION * material.yield_stress(plastic_strain_eq).value;
  return squared_equivalent<Dim>(s) >= yield * yield && contract<Dim>(s, d) > 0;
}

/// Factor c of the plastic part of D: D:d = E:d - c (s:d) s, c = 3G/(q^2 (1 + H'/(3G))), H' the slope of
/// sigma_y at ep. @param kinematic_modulus what a back stress adds to H', see backstress_return.hpp [stress]
template <int Dim>
double plastic_factor(const J2Parameters& material, const Stress<Dim>& s, double plastic_strain_eq,
                      double kinematic_modulus = 0) {
  const double G3 = 3 * material.elastic.G;
  const double H = material.yield_stress(plastic_strain_eq).slope + kinematic_modulus;
  return G3 / (squared_equivalent<Dim>(s) * (1 + H / G3));
}

/// d tau/dy for the rates y = (d_xx, d_yy, d_zz, d_xy, w_21) with w the spin of the rate: D in the strain columns,
/// w tau - tau w in the column of the rotation. @param backstress X where material.kinematic exists() [stress]
/// @param stress Kirchhoff stress tau [stress]; @param plastic true: D of METHOD.md (1.6), false: E
template <int Dim>
StressByIncrement<Dim> rate_moduli(const J2Parameters& material, const Stress<Dim>& stress,
                                   double plastic_strain_eq, bool plastic,
                                   const double* backstress = nullptr);

/// Forward Euler step of METHOD.md (1.6), the article's: tau = R tau_old R' + D(R s_old R'):dd,
/// ep += 3G (s:dd)/(q (3G + H')). No return: the stress leaves the yield surface, on purpose, by O(|dd|^2) a
/// step, and a step that crosses the surface stays elastic to its end (events are to cut it there).
/// @param elastic_increment 2G dev(dd) [stress]
/// @param s R s_old R' in, deviator at the end of the step out [stress]
/// @param plastic_strain_eq ep in and out [-]; @param yielded see loads
/// @return plastic increment >= 0
template <int Dim>
double forward_euler(const J2Parameters& material, const StepKinematics<Dim>& kin,
                     const Stress<Dim>& elastic_increment, Stress<Dim>& s, double& plastic_strain_eq,
                     bool yielded = false);

/// Derivative of its deviator with respect to the step's increments.
/// @param s_old R s_old R' [stress]; @param s_old_by its derivative
template <int Dim>
StressByIncrement<Dim> forward_euler_by_increment(const J2Parameters& material,
                                                  const StepKinematics<Dim>& kin, const Stress<Dim>& s_old,
                                                  const StressByIncrement<Dim>& s_old_by,
                                                  double plastic_strain_eq, bool yielded = false);

} // namespace burnish
