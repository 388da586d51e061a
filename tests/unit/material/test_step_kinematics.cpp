#include "unit/material/point_step.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {
const StrainFrame FRAMES[] = {StrainFrame::MIDPOINT, StrainFrame::END};
const Stress<2> SAMPLE = {1.3, -0.4, 0.7, 2.1};
} // namespace

TEST(StressAlgebra, AgainstTensorProducts) {
  EXPECT_DOUBLE_EQ(mean<2>(SAMPLE), 1.6 / 3);
  EXPECT_NEAR(mean<2>(deviator<2>(SAMPLE)), 0, 1e-16);
  EXPECT_DOUBLE_EQ(contract<2>(SAMPLE, SAMPLE), 1.3 * 1.3 + 0.4 * 0.4 + 0.7 * 0.7 + 2 * 2.1 * 2.1);
  EXPECT_DOUBLE_EQ(contraction_row<2>(SAMPLE) * SAMPLE, contract<2>(SAMPLE, SAMPLE));
  const Stress<2> uniaxial = {5, 0, 0, 0}, shear = {0, 0, 0, 2};
  EXPECT_NEAR(equivalent<2>(deviator<2>(uniaxial)), 5, 1e-14);
  EXPECT_NEAR(equivalent<2>(deviator<2>(shear)), 2 * std::sqrt(3.0), 1e-14);
  for (double angle : {-2.0, 0.3, 1.5}) {
    const Stress<2> expected = turned(SAMPLE, rotation(angle));
    expect_close(rotated(SAMPLE, std::cos(2 * angle), std::sin(2 * angle)), expected, 1, 1e-15, "R t R'");
    const auto at = [&](double a) { return turned(SAMPLE, rotation(a)); };
    expect_close(spin_rate(expected), finite_difference(at, angle, 1e-3), 1, 1e-11, "rate of R t R'");
  }
}

TEST(StepKinematics, RigidRotationIsExactForAnyAngle) {
  const Tensor<2> F_old = tensor(1.2, 0.3, -0.1, 0.8);
  for (StrainFrame frame : FRAMES)
    for (double angle : {-3.0, -0.3, 1e-9, 0.3, 1.0, 3.0}) {
      const StepKinematics<2> kin = step_kinematics(F_old, rotation(angle) * F_old, frame);
      EXPECT_LE(kin.strain.norm(), 1e-14 * (1 + std::abs(kin.spin))) << "angle " << angle;
      EXPECT_NEAR(kin.spin, 2 * std::tan(angle / 2), 1e-13 * (1 + std::abs(kin.spin))) << "angle " << angle;
      EXPECT_NEAR(kin.cos_alpha, std::cos(angle), 1e-14) << "angle " << angle;
      EXPECT_NEAR(kin.sin_alpha, std::sin(angle), 1e-14) << "angle " << angle;
      EXPECT_NEAR(kin.cos_2alpha, std::cos(2 * angle), 1e-14) << "angle " << angle;
      EXPECT_NEAR(kin.sin_2alpha, std::sin(2 * angle), 1e-14) << "angle " << angle;
    }
}

TEST(StepKinematics, MidpointStretchIsThirdOrderInTheLogarithm) {
  for (double stretch : {1.01, 1.1}) { // 2 (l - 1)/(l + 1) = ln l - (ln l)^3/12 + ...
    const StepKinematics<2> kin =
        step_kinematics(Tensor<2>::Identity(), tensor(stretch, 0, 0, 1), StrainFrame::MIDPOINT);
    const double log = std::log(stretch);
    EXPECT_NEAR((log - kin.strain[0]) / (log * log * log), 1. / 12, 1e-3);
    EXPECT_EQ(kin.strain[1], 0);
    EXPECT_EQ(kin.strain[3], 0);
  }
}

TEST(StepKinematics, SingularMidpointIsReported) {
  EXPECT_LE(step_kinematics(Tensor<2>::Identity(), tensor(-0.5, 0, 0, -3), StrainFrame::END).det_mid, 0);
  EXPECT_FALSE(step_kinematics(Tensor<2>::Identity(), tensor(NAN, 0, 0, 1), StrainFrame::END).det_mid > 0);
}

TEST(StepKinematics, EndFrameTurnsTheStrainByHalfTheRotation) {
  const Tensor<2> F_old = tensor(1, 0.1, 0, 1), F = tensor(1.1, -0.2, 0.4, 0.9);
  const StepKinematics<2> midpoint = step_kinematics(F_old, F, StrainFrame::MIDPOINT);
  const StepKinematics<2> end = step_kinematics(F_old, F, StrainFrame::END);
  const double alpha = 2 * std::atan(0.5 * midpoint.spin);
  expect_close(end.strain, turned(midpoint.strain, rotation(alpha / 2)), 1, 1e-15, "dd");
}

TEST(StepKinematics, LinearizationAgainstFiniteDifferences) {
  const Tensor<2> F_old = tensor(1.1, 0.2, -0.1, 0.9);
  const Tensor<2> ends[] = {F_old, tensor(1.15, 0.1, 0.05, 0.95), rotation(0.8) * tensor(1.3, 0.2, 0, 0.8)};
  for (StrainFrame frame : FRAMES)
    for (const Tensor<2>& F : ends) {
      const auto increments = [&](const Tensor<2>& at) {
        const StepKinematics<2> kin = step_kinematics(F_old, at, frame);
        return Eigen::Vector4d(kin.strain[0], kin.strain[1], kin.strain[3], 2 * std::atan(0.5 * kin.spin));
      };
      IncrementByF<2> measured;
      for (int c = 0; c < 4; ++c)
        measured.col(c) = finite_difference(
            [&](double t) {
              Tensor<2> moved = F;
              moved(c / 2, c % 2) += t;
              return increments(moved);
            },
            0, 1e-3);
      expect_close(finite_increment_by_F(step_kinematics(F_old, F, frame)), measured, 1, 1e-10, "dy/dF");
    }
}

TEST(StepKinematics, RateIsTheLimitOfAVanishingStep) {
  const Tensor<2> F = tensor(1.1, 0.2, -0.1, 0.9);
  for (StrainFrame frame : FRAMES)
    expect_close(rate_by_F(F.inverse()), finite_increment_by_F(step_kinematics(F, F, frame)), 1, 1e-14,
                 "dy/dF");
}
