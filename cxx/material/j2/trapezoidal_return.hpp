#pragma once
// Return to the yield surface q = sigma_y(ep) by the trapezoidal rule, and its derivative (METHOD.md (1.33) to (1.35)).
#include "material/j2/radial_return.hpp"

namespace burnish {

/// Where the straight path s + f D leaves the yield surface, METHOD.md (1.33).
template <int Dim> struct Exit {
  double f = 0;       ///< 0 where s is on the surface and D points outward
  Stress<Dim> normal; ///< (s + f D)/q, of q = 1
  double q = 0;       ///< of s + f D: sigma_y, but for a start outside [stress]
  double slope = 0;   ///< (3/2) (s + f D):D >= 0 [stress^2]
};

/// @param s start, D path, s + D outside [stress]; a start outside keeps its q: its path leaves a surface of that size
template <int Dim> Exit<Dim> exit_of(const Stress<Dim>& s, const Stress<Dim>& D, double yield) {
  const double A = squared_equivalent<Dim>(D), B = 1.5 * contract<Dim>(s, D);
  const double C = std::min(0., squared_equivalent<Dim>(s) - yield * yield);
  Exit<Dim> exit;
  exit.slope = std::sqrt(B * B - A * C);
  if (B > 0)
    exit.f = std::min(1., -C / (B + exit.slope));
  else if (A > 0)
    exit.f = std::min(1., (exit.slope - B) / A);
  const Stress<Dim> at = s + exit.f * D;
  exit.q = equivalent<Dim>(at);
  exit.normal = at / exit.q;
  return exit;
}

/// Plastic increment x > 0 of METHOD.md (1.34): q2 - 2 g x (c + sigma_y) - sigma_y^2 = 0 with sigma_y(ep + x); closed form
/// where hardening is linear, else Newton's method within a bracket, to rounding. Not finite where there is none.
/// @param yield of ep; @param q2 q^2 of the trial, > yield.value^2 [stress^2]; @param c (3/2) trial:normal [stress]
/// @param g half of what q loses per plastic strain, 3G/2 [stress]
double trapezoidal_increment(const HardeningLaw& hardening, const YieldStress& yield,
                             double plastic_strain_eq, double q2, double c, double g);

/// What a return has found, for its derivative.
template <int Dim> struct TrapezoidalReturn {
  double increment = 0; ///< x; 0: the path stays inside
  YieldStress before, after;
  Exit<Dim> exit;
  Stress<Dim> trial, half; ///< s + D; the trial less g x normal [stress]
  double c = 0;            ///< (3/2) trial:normal [stress]
};

/// s := s + D returned: s - 3G x (n0 + n1)/2 with n0 where the path leaves the surface, n1 of the end, q = sigma_y(ep + x).
/// @param s, plastic_strain_eq  in and out [stress, -]; @param D elastic increment of the deviator [stress]
template <int Dim>
TrapezoidalReturn<Dim> trapezoidal_return(const J2Parameters& material, const Stress<Dim>& D, Stress<Dim>& s,
                                          double& plastic_strain_eq) {
  TrapezoidalReturn<Dim> found;
  found.before = material.yield_stress(plastic_strain_eq);
  found.trial = s + D;
  const double q2 = squared_equivalent<Dim>(found.trial), yield = found.before.value;
  if (q2 <= yield * yield) {
    s = found.trial;
    return found;
  }
  const double g = 1.5 * material.elastic.G;
  found.exit = exit_of<Dim>(s, D, yield);
  found.c = 1.5 * contract<Dim>(found.trial, found.exit.normal);
  const double x =
      trapezoidal_increment(*material.hardening, found.before, plastic_strain_eq, q2, found.c, g);
  found.increment = x;
  found.half = found.trial - g * x * found.exit.normal;
  plastic_strain_eq += x;
  found.after = material.yield_stress(plastic_strain_eq);
  s = found.after.value / (found.after.value + g * x) * found.half;
  return found;
}

/// Row r with r b = (3/2) a:b.
template <int Dim> using ProductRow = Eigen::Matrix<double, 1, num_stress<Dim>>;
template <int Dim> ProductRow<Dim> product_row(const Stress<Dim>& a) { return 1.5 * contraction_row<Dim>(a); }

/// Derivative of Exit::normal, METHOD.md (1.35).
/// @param s_by, D_by, yield_by of the start, the path and sigma_y
template <int Dim>
StressByIncrement<Dim> normal_by(const Exit<Dim>& exit, const Stress<Dim>& D,
                                 const StressByIncrement<Dim>& s_by, const StressByIncrement<Dim>& D_by,
                                 const ScalarByIncrement<Dim>& yield_by) {
  StressByIncrement<Dim> by = s_by + exit.f * D_by; // at fixed f so far
  const ProductRow<Dim> row = product_row<Dim>(exit.normal);
  if (exit.f > 0 && exit.slope > 0) {
    const ScalarByIncrement<Dim> f_by = (exit.q / exit.slope) * (yield_by - row * by);
    by.noalias() += D * f_by;
  }
  const ScalarByIncrement<Dim> q_by = row * by;
  by.noalias() -= exit.normal * q_by;
  return by / exit.q;
}

/// trapezoidal_return with the exact chain rule, METHOD.md (1.35).
/// @param D_by of D; @param derivative of s and ep on entry, of the returned values on exit
template <int Dim>
double trapezoidal_return(const J2Parameters& material, const Stress<Dim>& D,
                          const StressByIncrement<Dim>& D_by, Stress<Dim>& s, double& plastic_strain_eq,
                          ReturnDerivative<Dim>& derivative) {
  const TrapezoidalReturn<Dim> found = trapezoidal_return<Dim>(material, D, s, plastic_strain_eq);
  const double x = found.increment;
  if (x == 0) {
    derivative.s += D_by;
    return 0;
  }
  const Stress<Dim>& normal = found.exit.normal;
  ScalarByIncrement<Dim>& ep_by = derivative.plastic_strain_eq;
  const StressByIncrement<Dim> n_by =
      normal_by<Dim>(found.exit, D, derivative.s, D_by, found.before.slope * ep_by);
  derivative.s += D_by; // of the trial
  const double g = 1.5 * material.elastic.G, H = found.after.slope, yield = found.after.value;
  const double m = yield + g * x, theta = yield / m;
  const ProductRow<Dim> trial_row = product_row<Dim>(found.trial);
  const ScalarByIncrement<Dim> c_by = product_row<Dim>(normal) * derivative.s + trial_row * n_by;
  const ScalarByIncrement<Dim> x_by =
      (trial_row * derivative.s - g * x * c_by - m * H * ep_by) / (g * (found.c + yield) + m * H);
  ep_by += x_by;
  const ScalarByIncrement<Dim> theta_by = (H * (1 - theta) * ep_by - theta * g * x_by) / m;
  derivative.s.noalias() -= g * normal * x_by;
  derivative.s -= g * x * n_by;
  derivative.s *= theta;
  derivative.s.noalias() += found.half * theta_by;
  return x;
}

} // namespace burnish
