#pragma once
// Radial return to the yield surface q = sigma_y(ep) with linear hardening, and its derivative.
#include "material/stress_algebra.hpp"

namespace burnish {

/// Derivatives of the deviator and of ep with respect to the step's increments, while a return runs.
template <int Dim> struct ReturnDerivative {
  StressByIncrement<Dim> s = StressByIncrement<Dim>::Zero();
  ScalarByIncrement<Dim> plastic_strain_eq = ScalarByIncrement<Dim>::Zero();
};

/// Backward Euler step of (3.1) from the deviatoric trial stress:
///   dep = (q - sigma_y(ep))/(3G + H'), s := (1 - 3G dep/q) s; nothing if q <= sigma_y(ep).
/// @param s  trial deviator in, returned deviator out [stress]; @param plastic_strain_eq ep in and out [-]
/// @return dep >= 0
template <int Dim>
double radial_return(const J2Parameters& material, Stress<Dim>& s, double& plastic_strain_eq) {
  const double yield = yield_stress_at(material, plastic_strain_eq), q2 = squared_equivalent<Dim>(s);
  if (q2 <= yield * yield) return 0;
  const double q = std::sqrt(q2), dep = (q - yield) / (3 * material.G + material.hardening_modulus);
  plastic_strain_eq += dep;
  s *= 1 - 3 * material.G * dep / q;
  return dep;
}

/// The same with the chain rule (algorithms.md section 2): dq = 1.5 s:ds/q,
/// d(dep) = (dq - H' d ep)/(3G + H'), d theta = H' d ep_new/q - theta dq/q, ds := theta ds + s_trial d theta.
/// @param derivative of the trial on entry, of the returned values on exit
template <int Dim>
double radial_return(const J2Parameters& material, Stress<Dim>& s, double& plastic_strain_eq,
                     ReturnDerivative<Dim>& derivative) {
  const Stress<Dim> trial = s;
  const double dep = radial_return<Dim>(material, s, plastic_strain_eq);
  if (dep == 0) return 0;
  const double H = material.hardening_modulus;
  const double q = equivalent<Dim>(trial), theta = 1 - 3 * material.G * dep / q;
  const ScalarByIncrement<Dim> dq = (1.5 / q) * contraction_row<Dim>(trial) * derivative.s;
  derivative.plastic_strain_eq += (dq - H * derivative.plastic_strain_eq) / (3 * material.G + H);
  const ScalarByIncrement<Dim> dtheta = (H / q) * derivative.plastic_strain_eq - (theta / q) * dq;
  derivative.s *= theta;
  derivative.s.noalias() += trial * dtheta;
  return dep;
}

} // namespace burnish
