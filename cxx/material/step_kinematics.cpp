#include "material/step_kinematics.hpp"

namespace burnish {
namespace {

Stress<2> midpoint_strain(const Gradient<2>& G) { return {G[0], G[3], G[ZZ], 0.5 * (G[1] + G[2])}; }

} // namespace

void turn_by_rate(CorotationalRate rate, const Gradient<2>& F_old, const Gradient<2>& F,
                  StepKinematics<2>& kin) {
  kin.rate = rate;
  kin.F = F;
  kin.F_mid = 0.5 * (F_old + F);
  PlaneRotation turn{kin.cos_alpha, kin.sin_alpha};
  if (rate == CorotationalRate::GREEN_NAGHDI) turn = polar_rotation(F_old, F);
  if (rate == CorotationalRate::LOGARITHMIC) {
    const double excess = logarithmic_excess(kin.F_mid, midpoint_strain(kin.G));
    turn = turn * PlaneRotation{std::cos(excess), std::sin(excess)};
  }
  kin.cos_alpha = turn.cos;
  kin.sin_alpha = turn.sin;
}

void set_small_step(const Gradient<2>& dF, StepKinematics<2>& kin) {
  kin.rate = CorotationalRate::SMALL_STRAIN;
  kin.det_mid = 1;
  kin.F_mid_inverse = undeformed<2>();
  kin.G = dF;
  kin.strain = midpoint_strain(kin.G);
}

AngleByF turn_by_F(const StepKinematics<2>& kin, const StrainByF& strain_by_F, const AngleByF& spin_by_F) {
  if (kin.rate == CorotationalRate::SMALL_STRAIN) return AngleByF::Zero();
  if (kin.rate == CorotationalRate::GREEN_NAGHDI) return polar_angle_by_F(kin.F);
  if (kin.rate == CorotationalRate::LOGARITHMIC)
    return spin_by_F + logarithmic_excess_by_F(kin.F_mid, midpoint_strain(kin.G), strain_by_F, 0.5);
  return spin_by_F;
}

IncrementByF<2> rate_by_F(const Gradient<2>& F, const Gradient<2>& F_inverse, CorotationalRate rate) {
  IncrementByF<2> by_F = rate_by_F(F_inverse);
  if (rate == CorotationalRate::SMALL_STRAIN) by_F.row(4).setZero();
  if (rate == CorotationalRate::GREEN_NAGHDI) by_F.row(4) = polar_angle_by_F(F);
  if (rate == CorotationalRate::LOGARITHMIC)
    for (int c = 0; c < 4; ++c) by_F(4, c) += logarithmic_excess(F, by_F.col(c).head<4>());
  return by_F;
}

StepIncrements<2> increments_of(const StepKinematics<2>& kin) {
  StepIncrements<2> increments;
  increments.y << kin.strain, std::atan2(kin.sin_alpha, kin.cos_alpha);
  increments.by_F = finite_increment_by_F(kin);
  return increments;
}

} // namespace burnish
