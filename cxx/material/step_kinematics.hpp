#pragma once
// Kinematics of one step at one point: midpoint gradient, strain increment, Hughes-Winget rotation
// (method.md section 1).
#include "material/stress_algebra.hpp"

namespace burnish {

/// The increments y of a step, from which the stress update starts: strain components, then rotations.
/// Dim 2: (dd_xx, dd_yy, dd_xy, alpha). IncrementByF: dy/dF, columns F_kL ordered k*Dim + L.
template <int Dim> using IncrementByF = Eigen::Matrix<double, Dim * Dim, Dim * Dim>;

template <int Dim> struct StepKinematics {
  StrainFrame frame = StrainFrame::MIDPOINT;
  Tensor<Dim> G;                         ///< midpoint gradient dU F_mid^-1 [-]
  Tensor<Dim> F_mid_inverse;             ///< inverse of (F_old + F)/2 [-]
  double det_mid = 0;                    ///< det F_mid; the rest is set only if it is > 0
  Stress<Dim> strain;                    ///< dd = sym G, in its frame [-]
  double spin = 0;                       ///< dw_21 = (G_21 - G_12)/2, counter-clockwise positive [-]
  double cos_alpha = 1, sin_alpha = 0;   ///< rotation alpha = 2 atan(dw_21/2)
  double cos_2alpha = 1, sin_2alpha = 0; ///< twice that
};

/// From F_old to F in one step. A rigid rotation by any angle below pi gives dd = 0 and alpha = that angle.
/// With StrainFrame::END, dd = Q sym(G) Q' with Q the rotation by alpha/2 (a departure from method.md).
/// Never throws: where det_mid is not > 0 the other members are not set.
inline StepKinematics<2> step_kinematics(const Tensor<2>& F_old, const Tensor<2>& F, StrainFrame frame) {
  StepKinematics<2> kin;
  kin.frame = frame;
  const Tensor<2> F_mid = 0.5 * (F_old + F);
  kin.det_mid = F_mid(0, 0) * F_mid(1, 1) - F_mid(0, 1) * F_mid(1, 0);
  if (!(kin.det_mid > 0)) return kin;
  kin.F_mid_inverse << F_mid(1, 1), -F_mid(0, 1), -F_mid(1, 0), F_mid(0, 0);
  kin.F_mid_inverse /= kin.det_mid;
  kin.G.noalias() = (F - F_old) * kin.F_mid_inverse;
  kin.spin = 0.5 * (kin.G(1, 0) - kin.G(0, 1));
  // cos and sin of alpha from t = tan(alpha/2) = dw_21/2, then of 2 alpha
  const double t = 0.5 * kin.spin, scale = 1 / (1 + t * t);
  kin.cos_alpha = (1 - t * t) * scale;
  kin.sin_alpha = 2 * t * scale;
  kin.cos_2alpha = (kin.cos_alpha - kin.sin_alpha) * (kin.cos_alpha + kin.sin_alpha);
  kin.sin_2alpha = 2 * kin.cos_alpha * kin.sin_alpha;
  kin.strain = {kin.G(0, 0), kin.G(1, 1), 0, 0.5 * (kin.G(0, 1) + kin.G(1, 0))};
  if (frame == StrainFrame::END) kin.strain = rotated(kin.strain, kin.cos_alpha, kin.sin_alpha);
  return kin;
}

/// dy/dF for dG = left dF right and d(alpha) = d(dw_21)/(1 + dw_21^2/4).
inline IncrementByF<2> increment_by_F(const Tensor<2>& left, const Tensor<2>& right, double spin) {
  const double turn = 0.5 / (1 + 0.25 * spin * spin);
  IncrementByF<2> by_F;
  for (int k = 0; k < 2; ++k)
    for (int L = 0; L < 2; ++L) {
      const double G00 = left(0, k) * right(L, 0), G01 = left(0, k) * right(L, 1);
      const double G10 = left(1, k) * right(L, 0), G11 = left(1, k) * right(L, 1);
      by_F.col(2 * k + L) << G00, G11, 0.5 * (G01 + G10), turn * (G10 - G01);
    }
  return by_F;
}

/// Exact linearization of the finite step: dG = (I - G/2) dF F_mid^-1; in the end frame
/// d(dd) = Q d(sym G) Q' + (w dd - dd w) d(alpha)/2 with w_21 = 1.
inline IncrementByF<2> finite_increment_by_F(const StepKinematics<2>& kin) {
  const Tensor<2> left = Tensor<2>::Identity() - 0.5 * kin.G;
  IncrementByF<2> by_F = increment_by_F(left, kin.F_mid_inverse, kin.spin);
  if (kin.frame == StrainFrame::MIDPOINT) return by_F;
  const Stress<2> turning = 0.5 * spin_rate(kin.strain);
  for (int c = 0; c < 4; ++c) {
    const Stress<2> midpoint = {by_F(0, c), by_F(1, c), 0, by_F(2, c)};
    const Stress<2> end = rotated(midpoint, kin.cos_alpha, kin.sin_alpha) + by_F(3, c) * turning;
    by_F.col(c) << end[0], end[1], end[3], by_F(3, c);
  }
  return by_F;
}

/// Rates at the configuration F: L = dF F^-1, y = (d_xx, d_yy, d_xy, w_21); the limit of a vanishing step.
inline IncrementByF<2> rate_by_F(const Tensor<2>& F_inverse) {
  return increment_by_F(Tensor<2>::Identity(), F_inverse, 0);
}

/// Strain part of the increments as strain components: d(dd)/dy, zeros in the columns of the rotation.
inline StressByIncrement<2> strain_by_increment() {
  StressByIncrement<2> by = StressByIncrement<2>::Zero();
  by(0, 0) = by(1, 1) = by(3, 2) = 1;
  return by;
}

} // namespace burnish
