#pragma once
// Kinematics of a step at a point: midpoint gradient, strain increment, rotation of the corotational rate (METHOD.md 1.6).
#include "material/corotational_rate.hpp"
#include "material/step_increments.hpp"
#include "material/update_options.hpp"

namespace burnish {

/// What the increments y of a step are made of: strain components as Stress<Dim>, then rotations. Dim 2: (dd_xx, dd_yy, dd_zz,
/// dd_xy, alpha); Dim 3: step_kinematics_in_space.hpp.
template <int Dim> struct StepKinematics {
  StrainFrame frame = StrainFrame::MIDPOINT;
  CorotationalRate rate = CorotationalRate::JAUMANN;
  Gradient<Dim> G;                       ///< midpoint gradient dF F_mid^-1; G_zz = dF_zz/F_mid,zz [-]
  Gradient<Dim> F_mid_inverse;           ///< inverse of F_mid = (F_old + F)/2 [-]
  double det_mid = 0;                    ///< determinant(F_mid); the rest is set only if it is > 0
  Stress<Dim> strain;                    ///< dd = sym G, in its frame [-]
  double spin = 0;                       ///< dw_21 = (G_21 - G_12)/2, counter-clockwise positive [-]
  double cos_alpha = 1, sin_alpha = 0;   ///< rotation alpha of the rate: Jaumann 2 atan(dw_21/2)
  double cos_2alpha = 1, sin_2alpha = 0; ///< twice that
  Gradient<Dim> F, F_mid;                ///< end and middle of the step; not set for JAUMANN [-]
};

/// R t R' with the rotation of the step.
inline Stress<2> rotated(const Stress<2>& t, const StepKinematics<2>& kin) {
  return rotated(t, kin.cos_2alpha, kin.sin_2alpha);
}

/// Rotation of a step by another rate than JAUMANN. @param kin that of JAUMANN in, rate, alpha, F and F_mid of it out
void turn_by_rate(CorotationalRate rate, const Gradient<2>& F_old, const Gradient<2>& F,
                  StepKinematics<2>& kin);
/// The step of small strains, METHOD.md (1.36): dd = sym dF, nothing turns, det_mid = 1. @param kin as constructed
void set_small_step(const Gradient<2>& dF, StepKinematics<2>& kin);
/// d(alpha)/dF of it. @param strain_by_F of sym G; @param spin_by_F d(alpha)/dF of JAUMANN
AngleByF turn_by_F(const StepKinematics<2>& kin, const StrainByF& strain_by_F, const AngleByF& spin_by_F);

/// From F_old to F in one step. A rigid rotation by any angle below pi gives dd = 0 and alpha = that angle, with every
/// rate.
/// With StrainFrame::END, dd = Q sym(G) Q' with Q the rotation by alpha/2, METHOD.md (1.14).
/// Never throws: where det_mid is not > 0 the other members are not set.
inline StepKinematics<2> step_kinematics(const Gradient<2>& F_old, const Gradient<2>& F, StrainFrame frame,
                                         CorotationalRate rate = CorotationalRate::JAUMANN) {
  StepKinematics<2> kin;
  if (rate == CorotationalRate::SMALL_STRAIN) {
    set_small_step(F - F_old, kin);
    return kin;
  }
  kin.frame = frame;
  const Gradient<2> F_mid = 0.5 * (F_old + F);
  kin.det_mid = determinant(F_mid);
  if (!(kin.det_mid > 0)) return kin;
  kin.F_mid_inverse = adjugate(F_mid) / (F_mid[0] * F_mid[3] - F_mid[1] * F_mid[2]);
  kin.G = product(F - F_old, kin.F_mid_inverse);
  kin.spin = 0.5 * (kin.G[2] - kin.G[1]);
  // cos and sin of alpha from t = tan(alpha/2) = dw_21/2, then of 2 alpha
  const double t = 0.5 * kin.spin, scale = 1 / (1 + t * t);
  kin.cos_alpha = (1 - t * t) * scale;
  kin.sin_alpha = 2 * t * scale;
  if (rate != CorotationalRate::JAUMANN) turn_by_rate(rate, F_old, F, kin);
  kin.cos_2alpha = (kin.cos_alpha - kin.sin_alpha) * (kin.cos_alpha + kin.sin_alpha);
  kin.sin_2alpha = 2 * kin.cos_alpha * kin.sin_alpha;
  kin.strain = {kin.G[0], kin.G[3], kin.G[4], 0.5 * (kin.G[1] + kin.G[2])};
  if (frame == StrainFrame::END) kin.strain = rotated(kin.strain, kin.cos_alpha, kin.sin_alpha);
  return kin;
}

/// dy/dF for dG = left dF right and d(alpha) = d(dw_21)/(1 + dw_21^2/4); dG_zz = left_zz right_zz dF_zz.
inline IncrementByF<2> increment_by_F(const Gradient<2>& left, const Gradient<2>& right, double spin) {
  const double turn = 0.5 / (1 + 0.25 * spin * spin);
  IncrementByF<2> by_F = IncrementByF<2>::Zero();
  for (int k = 0; k < 2; ++k)
    for (int L = 0; L < 2; ++L) {
      const double G00 = left[k] * right[2 * L], G01 = left[k] * right[2 * L + 1];
      const double G10 = left[2 + k] * right[2 * L], G11 = left[2 + k] * right[2 * L + 1];
      auto column = by_F.col(2 * k + L);
      column[0] = G00;
      column[1] = G11;
      column[3] = 0.5 * (G01 + G10);
      column[4] = turn * (G10 - G01);
    }
  by_F(2, ZZ) = left[ZZ] * right[ZZ];
  return by_F;
}

/// Exact linearization of the finite step: dG = (I - G/2) dF F_mid^-1; in the end frame
/// d(dd) = Q d(sym G) Q' + (w dd - dd w) d(alpha)/2 with w_21 = 1.
inline IncrementByF<2> finite_increment_by_F(const StepKinematics<2>& kin) {
  Gradient<2> left = undeformed<2>();
  if (kin.rate != CorotationalRate::SMALL_STRAIN) left -= 0.5 * kin.G;
  IncrementByF<2> by_F = increment_by_F(left, kin.F_mid_inverse, kin.spin);
  if (kin.rate != CorotationalRate::JAUMANN) by_F.row(4) = turn_by_F(kin, by_F.topRows<4>(), by_F.row(4));
  if (kin.frame == StrainFrame::MIDPOINT) return by_F;
  const Stress<2> turning = 0.5 * spin_rate(kin.strain);
  for (int c = 0; c < 4; ++c) { // the last column, dF_zz, does not turn
    const Stress<2> midpoint = by_F.col(c).head<4>();
    by_F.col(c).head<4>() = rotated(midpoint, kin.cos_alpha, kin.sin_alpha) + by_F(4, c) * turning;
  }
  return by_F;
}

/// y of a step and dy/dF. @param kin det_mid > 0
StepIncrements<2> increments_of(const StepKinematics<2>& kin);

/// Rates at the configuration F: L = dF F^-1, y = (d_xx, d_yy, d_zz, d_xy, w_21); the limit of a vanishing
/// step with the Jaumann rate.
inline IncrementByF<2> rate_by_F(const Gradient<2>& F_inverse) {
  return increment_by_F(undeformed<2>(), F_inverse, 0);
}
/// The same with the spin of any rate in the last row. @param F_inverse of F
IncrementByF<2> rate_by_F(const Gradient<2>& F, const Gradient<2>& F_inverse, CorotationalRate rate);

} // namespace burnish
