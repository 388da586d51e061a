#pragma once
// Radial return to the yield surface q = sigma_y(ep), and its derivative.
#include "material/j2/parameters.hpp"

namespace burnish {

/// Derivatives of the deviator and of ep with respect to the step's increments, while a return runs.
template <int Dim> struct ReturnDerivative {
  StressByIncrement<Dim> s = StressByIncrement<Dim>::Zero();
  ScalarByIncrement<Dim> plastic_strain_eq = ScalarByIncrement<Dim>::Zero();
};

/// Backward Euler step of METHOD.md (1.6) from the deviatoric trial stress: with x the plastic increment,
///   q - 3G x = sigma_y(ep + x), s := (1 - 3G x/q) s; nothing if q <= sigma_y(ep).
/// @param s  trial deviator in, returned deviator out [stress]; @param plastic_strain_eq ep in and out [-]
/// @return x >= 0
template <int Dim>
double radial_return(const J2Parameters& material, Stress<Dim>& s, double& plastic_strain_eq) {
  const HardeningLaw& hardening = *material.hardening;
  const YieldStress yield = hardening.at(plastic_strain_eq);
  const double q2 = squared_equivalent<Dim>(s);
  if (q2 <= yield.value * yield.value) return 0;
  const double q = std::sqrt(q2), G = material.elastic.G;
  const double increment = plastic_increment(hardening, yield, plastic_strain_eq, q, 3 * G);
  plastic_strain_eq += increment;
  s *= 1 - 3 * G * increment / q;
  return increment;
}

/// The same with the chain rule, METHOD.md (1.17): dq = 1.5 s:ds/q, H' = slope of sigma_y at the end,
/// dx = (dq - H' d ep)/(3G + H'), d theta = H' d ep_new/q - theta dq/q, ds := theta ds + s_trial d theta.
/// @param derivative of the trial on entry, of the returned values on exit
template <int Dim>
double radial_return(const J2Parameters& material, Stress<Dim>& s, double& plastic_strain_eq,
                     ReturnDerivative<Dim>& derivative) {
  const Stress<Dim> trial = s;
  const double increment = radial_return<Dim>(material, s, plastic_strain_eq);
  if (increment == 0) return 0;
  const double H = material.yield_stress(plastic_strain_eq).slope, G = material.elastic.G;
  const double q = equivalent<Dim>(trial), theta = 1 - 3 * G * increment / q;
  const ScalarByIncrement<Dim> dq = (1.5 / q) * contraction_row<Dim>(trial) * derivative.s;
  derivative.plastic_strain_eq += (dq - H * derivative.plastic_strain_eq) / (3 * G + H);
  const ScalarByIncrement<Dim> dtheta = (H / q) * derivative.plastic_strain_eq - (theta / q) * dq;
  derivative.s *= theta;
  derivative.s.noalias() += trial * dtheta;
  return increment;
}

} // namespace burnish
