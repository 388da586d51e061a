#include "unit/material/j2/point_walk.hpp"

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
      const StepKinematics<2> kin = kinematics(F_old, rotation(angle) * F_old, frame);
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
        kinematics(Tensor<2>::Identity(), tensor(stretch, 0, 0, 1), StrainFrame::MIDPOINT);
    const double log = std::log(stretch);
    EXPECT_NEAR((log - kin.strain[0]) / (log * log * log), 1. / 12, 1e-3);
    EXPECT_EQ(kin.strain[1], 0);
    EXPECT_EQ(kin.strain[3], 0);
  }
}

TEST(StepKinematics, SingularMidpointIsReported) {
  EXPECT_LE(kinematics(Tensor<2>::Identity(), tensor(-0.5, 0, 0, -3), StrainFrame::END).det_mid, 0);
  EXPECT_FALSE(kinematics(Tensor<2>::Identity(), tensor(NAN, 0, 0, 1), StrainFrame::END).det_mid > 0);
}

TEST(StepKinematics, EndFrameTurnsTheStrainByHalfTheRotation) {
  const Tensor<2> F_old = tensor(1, 0.1, 0, 1), F = tensor(1.1, -0.2, 0.4, 0.9);
  const StepKinematics<2> midpoint = kinematics(F_old, F, StrainFrame::MIDPOINT);
  const StepKinematics<2> end = kinematics(F_old, F, StrainFrame::END);
  const double alpha = 2 * std::atan(0.5 * midpoint.spin);
  expect_close(end.strain, turned(midpoint.strain, rotation(alpha / 2)), 1, 1e-15, "dd");
}

TEST(StepKinematics, StretchOutOfThePlaneIsOnItsOwn) {
  const Tensor<2> in_plane_old = tensor(1.1, 0.2, -0.1, 0.9), in_plane = tensor(1.15, 0.1, 0.05, 0.95);
  for (StrainFrame frame : FRAMES) {
    const StepKinematics<2> plane = kinematics(in_plane_old, in_plane, frame);
    const StepKinematics<2> kin =
        kinematics(gradient(in_plane_old, 0.8), gradient(in_plane, 1.2), frame); // F_mid,zz = 1
    EXPECT_EQ(plane.strain[2], 0);
    EXPECT_NEAR(kin.strain[2], 0.4, 1e-15);
    EXPECT_NEAR(kin.det_mid, plane.det_mid, 1e-15);
    for (int k : {0, 1, 3}) EXPECT_EQ(kin.strain[k], plane.strain[k]);
    EXPECT_EQ(kin.spin, plane.spin);
  }
}

TEST(StepKinematics, LinearizationAgainstFiniteDifferences) {
  using Increments = Eigen::Matrix<double, 5, 1>;
  const Gradient<2> F_old = gradient(tensor(1.1, 0.2, -0.1, 0.9), 1.1);
  const Gradient<2> ends[] = {F_old, gradient(tensor(1.15, 0.1, 0.05, 0.95), 0.9),
                              gradient(rotation(0.8) * tensor(1.3, 0.2, 0, 0.8), 1.4)};
  for (StrainFrame frame : FRAMES)
    for (const Gradient<2>& F : ends) {
      const auto increments = [&](const Gradient<2>& at) {
        const StepKinematics<2> kin = step_kinematics(F_old, at, frame);
        Increments y;
        y << kin.strain, 2 * std::atan(0.5 * kin.spin);
        return y;
      };
      IncrementByF<2> measured;
      for (int c = 0; c < 5; ++c)
        measured.col(c) =
            finite_difference([&](double t) { return increments(F + t * Gradient<2>::Unit(c)); }, 0, 1e-3);
      expect_close(finite_increment_by_F(step_kinematics(F_old, F, frame)), measured, 1, 1e-10, "dy/dF");
    }
}

TEST(StepKinematics, RateIsTheLimitOfAVanishingStep) {
  const Gradient<2> F = gradient(tensor(1.1, 0.2, -0.1, 0.9), 1.3);
  for (StrainFrame frame : FRAMES)
    expect_close(rate_by_F(inverse(F)), finite_increment_by_F(step_kinematics(F, F, frame)), 1, 1e-14,
                 "dy/dF");
}
