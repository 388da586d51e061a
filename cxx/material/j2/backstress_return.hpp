#pragma once
// Return to the yield surface q(s - X) = sigma_y(ep) around a back stress X, and its derivative (METHOD.md 1.11).
#include "material/j2/substepped_return.hpp"

namespace burnish {

/// Derivatives of s, ep and X with respect to the step's increments, while a return runs.
template <int Dim> struct BackstressDerivative : ReturnDerivative<Dim> {
  StressByIncrement<Dim> backstress = StressByIncrement<Dim>::Zero();
};

/// Modulus that the back stress adds to H' as the surface moves, C - gamma (3/2) xi:X/q(xi), METHOD.md (1.25) [stress].
/// @param xi s - X, not zero [stress]; @param backstress X [stress]
template <int Dim>
double kinematic_modulus(const KinematicHardening& law, const Stress<Dim>& xi,
                         const Stress<Dim>& backstress) {
  if (law.recovery == 0) return law.modulus;
  return law.modulus - 1.5 * law.recovery * contract<Dim>(xi, backstress) / equivalent<Dim>(xi);
}

/// Plastic increment x >= 0 of METHOD.md (1.26): q(s - theta X) - (3G + theta C) x = sigma_y(ep + x) with
/// theta = 1/(1 + gamma x), to rounding; 0 if q(s - X) <= sigma_y(ep). Not finite where there is none: see local_solve.
/// @param s trial deviator [stress]
template <int Dim>
double backstress_increment(const J2Parameters& material, const Stress<Dim>& s, double plastic_strain_eq,
                            const Stress<Dim>& backstress);

/// Backward Euler step from the trial: with n = (s - theta X)/q,
///   s := s - 3G x n, X := theta (X + C x n), ep := ep + x.
/// @param s, plastic_strain_eq, backstress  trial in, returned out [stress, -, stress]; @return x >= 0
template <int Dim>
double backstress_return(const J2Parameters& material, Stress<Dim>& s, double& plastic_strain_eq,
                         Stress<Dim>& backstress);
/// The same with the exact chain rule; `derivative` of the trial on entry, of the returned values on exit.
template <int Dim>
double backstress_return(const J2Parameters& material, Stress<Dim>& s, double& plastic_strain_eq,
                         Stress<Dim>& backstress, BackstressDerivative<Dim>& derivative);

} // namespace burnish
