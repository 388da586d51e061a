#include "material/step_kinematics_in_space.hpp"
#include "base/cross_matrix.hpp"
#include "material/corotational_rate_in_space.hpp"

namespace burnish {
namespace {

using Quaternion = Eigen::Quaterniond;
using SpinByF = Eigen::Matrix<double, 3, 9>;

Quaternion quaternion(double w, const Vector<3>& v) { return Quaternion(w, v[0], v[1], v[2]).normalized(); }
Quaternion half_of(const Quaternion& p) { // of the smaller angle
  return p.w() < 0 ? quaternion(1 - p.w(), -p.vec()) : quaternion(1 + p.w(), p.vec());
}

/// d(sym G), then the axial vector of d(skew G), for dG = left dF right.
IncrementByF<3> increment_by_F(const Gradient<3>& left, const Gradient<3>& right) {
  IncrementByF<3> by_F;
  for (int k = 0; k < 3; ++k)
    for (int L = 0; L < 3; ++L) {
      const Tensor<3> dG = mesh_part<3>(left).col(k) * mesh_part<3>(right).row(L);
      by_F.col(3 * k + L) << stress_of(dG), axial_vector(dG);
    }
  return by_F;
}

// d(phi) of the rotation with the Gibbs vector spin/2, METHOD.md (1.38)
Tensor<3> cayley_tangent(const Vector<3>& spin) {
  return (Tensor<3>::Identity() + 0.5 * cross_matrix(spin)) / (1 + 0.25 * spin.squaredNorm());
}

Quaternion rotation_of(const StepKinematics<3>& kin, const Gradient<3>& F_old) {
  if (kin.rate == CorotationalRate::GREEN_NAGHDI)
    return Quaternion(polar_rotation(kin.F) * polar_rotation(F_old).transpose());
  const Quaternion jaumann = quaternion(1, 0.5 * kin.spin);
  if (kin.rate == CorotationalRate::JAUMANN) return jaumann;
  const double angle = kin.excess.norm();
  const Vector<3> axis = angle > 0 ? Vector<3>(kin.excess / angle) : Vector<3>::UnitX();
  const Quaternion half = half_of(jaumann);
  return half * Quaternion(Eigen::AngleAxisd(angle, axis)) * half;
}

// Spins of the step's rotation. @param by_F of increment_by_F
SpinByF turn_by_F(const StepKinematics<3>& kin, const IncrementByF<3>& by_F) {
  if (kin.rate == CorotationalRate::SMALL_STRAIN) return SpinByF::Zero();
  if (kin.rate == CorotationalRate::GREEN_NAGHDI) return polar_spin_by_F(kin.F);
  const SpinByF jaumann = cayley_tangent(kin.spin) * by_F.bottomRows<3>();
  if (kin.rate == CorotationalRate::JAUMANN) return jaumann;
  // R = H E H with H H the rotation of JAUMANN
  const Tensor<3> I = Tensor<3>::Identity();
  const Tensor<3> H = half_of(quaternion(1, 0.5 * kin.spin)).toRotationMatrix();
  const double angle = kin.excess.norm();
  const Tensor<3> E =
      angle > 0 ? Eigen::AngleAxisd(angle, kin.excess / angle).toRotationMatrix() : Tensor<3>(I);
  const StrainByF3 strain_by = by_F.topRows<6>();
  const SpinByF excess_by =
      logarithmic_excess_by_F(kin.F_mid, stress_of(mesh_part<3>(kin.G)), strain_by, 0.5);
  return (I + H * E) * (I + H).inverse() * jaumann + H * rotation_vector_tangent(kin.excess) * excess_by;
}

} // namespace

StepKinematics<3> step_kinematics(const Gradient<3>& F_old, const Gradient<3>& F, StrainFrame frame,
                                  CorotationalRate rate) {
  StepKinematics<3> kin;
  kin.rate = rate;
  if (rate == CorotationalRate::SMALL_STRAIN) {
    kin.det_mid = 1;
    kin.F_mid_inverse = undeformed<3>();
    kin.G = F - F_old;
    kin.strain = stress_of(mesh_part<3>(kin.G));
    return kin;
  }
  kin.frame = frame;
  kin.F = F;
  kin.F_mid = 0.5 * (F_old + F);
  kin.det_mid = determinant(kin.F_mid);
  if (!(kin.det_mid > 0)) return kin;
  kin.F_mid_inverse = inverse(kin.F_mid);
  kin.G = product(F - F_old, kin.F_mid_inverse);
  kin.spin = axial_vector(mesh_part<3>(kin.G));
  kin.strain = stress_of(mesh_part<3>(kin.G));
  if (rate == CorotationalRate::LOGARITHMIC) kin.excess = logarithmic_excess(kin.F_mid, kin.strain);
  const Quaternion turn = rotation_of(kin, F_old);
  kin.R = turn.toRotationMatrix();
  kin.R_half = half_of(turn).toRotationMatrix();
  if (frame == StrainFrame::END) kin.strain = rotated(kin.strain, kin.R_half);
  return kin;
}

IncrementByF<3> finite_increment_by_F(const StepKinematics<3>& kin) {
  Gradient<3> left = undeformed<3>();
  if (kin.rate != CorotationalRate::SMALL_STRAIN) left -= 0.5 * kin.G;
  IncrementByF<3> by_F = increment_by_F(left, kin.F_mid_inverse);
  by_F.bottomRows<3>() = turn_by_F(kin, by_F);
  if (kin.frame == StrainFrame::MIDPOINT) return by_F;
  const Eigen::Matrix<double, 6, 3> turning =
      spin_rate(kin.strain) * (Tensor<3>::Identity() + kin.R_half).inverse();
  for (int c = 0; c < 9; ++c) {
    const Stress<3> midpoint = by_F.col(c).head<6>();
    by_F.col(c).head<6>() = rotated(midpoint, kin.R_half) + turning * by_F.col(c).tail<3>();
  }
  return by_F;
}

IncrementByF<3> rate_by_F(const Gradient<3>& F, const Gradient<3>& F_inverse, CorotationalRate rate) {
  IncrementByF<3> by_F = increment_by_F(undeformed<3>(), F_inverse);
  if (rate == CorotationalRate::SMALL_STRAIN) by_F.bottomRows<3>().setZero();
  if (rate == CorotationalRate::GREEN_NAGHDI) by_F.bottomRows<3>() = polar_spin_by_F(F);
  if (rate == CorotationalRate::LOGARITHMIC)
    for (int c = 0; c < 9; ++c)
      by_F.col(c).tail<3>() += logarithmic_excess(F, Stress<3>(by_F.col(c).head<6>()));
  return by_F;
}

StepIncrements<3> increments_of(const StepKinematics<3>& kin) {
  const Eigen::AngleAxisd turn(kin.R);
  StepIncrements<3> increments;
  increments.y << kin.strain, turn.angle() * turn.axis();
  increments.by_F = finite_increment_by_F(kin);
  return increments;
}

} // namespace burnish
