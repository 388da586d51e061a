// Strains and rotation of a step in space, every rate: against the plane, rigid rotations, finite differences.
#include "base/cross_matrix.hpp"
#include "material/corotational_rate_in_space.hpp"
#include "unit/material/in_space.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

const CorotationalRate RATES[] = {CorotationalRate::JAUMANN, CorotationalRate::GREEN_NAGHDI,
                                  CorotationalRate::LOGARITHMIC};
const StrainFrame FRAMES[] = {StrainFrame::MIDPOINT, StrainFrame::END};
const Vector<3> AXES[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 2, -1}, {-0.3, 0.2, 0.9}};
const Stress<3> SAMPLE = (Stress<3>() << 1, -0.4, 0.7, 0.3, -0.6, 0.2).finished();

} // namespace

TEST(StepKinematicsInSpace, SpinRateIsTheDerivativeOfTheRotatedStress) {
  for (int k = 0; k < 3; ++k) {
    const auto at = [&](double t) { return rotated(SAMPLE, turn_about(Vector<3>::Unit(k), t)); };
    expect_close(spin_rate(SAMPLE).col(k), finite_difference(at, 0, 1e-3), 1, 1e-11, "spin rate");
  }
}

TEST(StepKinematicsInSpace, RigidRotationIsExactAboutAnyAxis) {
  const Gradient<3> F_old = gradient_in_space(0.5);
  for (CorotationalRate rate : RATES)
    for (StrainFrame frame : FRAMES)
      for (const Vector<3>& axis : AXES)
        for (double angle : {-3.0, -0.3, 1e-9, 0.3, 1.0, 3.0}) {
          const Tensor<3> R = turn_about(axis, angle);
          const StepKinematics<3> kin = step_kinematics(F_old, turned(R, F_old), frame, rate);
          EXPECT_LE(kin.strain.norm(), 2e-14 * (1 + kin.spin.norm()));
          EXPECT_LE((kin.R - R).norm(), 3e-13) << "angle " << angle;
          EXPECT_LE((kin.R_half - turn_about(axis, 0.5 * angle)).norm(), 3e-13) << "angle " << angle;
        }
}

TEST(StepKinematicsInSpace, InAPlaneItIsThatOfThePlane) {
  const Gradient<2> F_old = gradient(tensor(1.1, 0.2, -0.1, 0.9), 1.1);
  const Gradient<2> ends[] = {gradient(tensor(1.15, 0.1, 0.05, 0.95), 0.9),
                              gradient(rotation(0.8) * tensor(1.3, 0.2, 0, 0.8), 1.4),
                              gradient(rotation(-0.6) * tensor(3, 1.2, 0.4, 0.9), 0.7)};
  for (CorotationalRate rate : RATES)
    for (StrainFrame frame : FRAMES)
      for (const Vector<3>& axis : AXES)
        for (const Gradient<2>& F : ends) {
          const Tensor<3> Q = turn_about(axis, 1.1);
          const StepKinematics<2> flat = step_kinematics(F_old, F, frame, rate);
          const StepKinematics<3> kin = step_kinematics(in_space(F_old, Q), in_space(F, Q), frame, rate);
          expect_close(kin.strain, in_space(flat.strain, Q), 1, 1e-13, "strain");
          const Tensor<3> R = turn_about(Q.col(2), std::atan2(flat.sin_alpha, flat.cos_alpha));
          expect_close(kin.R, R, 1, 1e-13, "R");
        }
}

TEST(StepKinematicsInSpace, LinearizationAgainstFiniteDifferences) {
  const Gradient<3> F_old = gradient_in_space(0.3);
  const Gradient<3> ends[] = {F_old, gradient_in_space(0.33),
                              turned(turn_about({1, -2, 0.5}, 0.8), gradient_in_space(0.5)),
                              turned(turn_about({0.3, 1, 1}, -1.2), gradient_in_space(-0.4)),
                              in_space(gradient(tensor(1.3, 0.2, 0.2, 1.3), 0.8), Tensor<3>::Identity())};
  for (CorotationalRate rate : RATES)
    for (StrainFrame frame : FRAMES)
      for (const Gradient<3>& F : ends) {
        const StepKinematics<3> now = step_kinematics(F_old, F, frame, rate);
        IncrementByF<3> measured;
        for (int c = 0; c < 9; ++c) {
          const auto at = [&](double t) {
            return step_kinematics(F_old, F + t * Gradient<3>::Unit(c), frame, rate);
          };
          measured.col(c).head<6>() = finite_difference([&](double t) { return at(t).strain; }, 0, 1e-3);
          measured.col(c).tail<3>() =
              axial_vector(finite_difference([&](double t) { return at(t).R; }, 0, 1e-3) * now.R.transpose());
        }
        expect_close(finite_increment_by_F(now), measured, 1, 2e-9, "dy/dF");
      }
}

TEST(StepKinematicsInSpace, RateIsTheLimitOfAVanishingStep) {
  const Gradient<3> F = gradient_in_space(0.4);
  for (CorotationalRate rate : RATES)
    for (StrainFrame frame : FRAMES)
      expect_close(rate_by_F(F, inverse(F), rate), finite_increment_by_F(step_kinematics(F, F, frame, rate)),
                   1, 1e-13, "dy/dF");
}

TEST(StepKinematicsInSpace, LogarithmicExcessAgainstItsDefinition) {
  // in the axes of V: -d_ij L(x) with x = h_i - h_j, L = coth x - 1/x, h = ln V; METHOD.md (1.39)
  const Tensor<3> Q = turn_about({1, 2, -1}, 0.7);
  for (const Vector<3>& h :
       {Vector<3>(0.7, -0.2, 0.1), Vector<3>(0.3, 0.3 + 1e-7, -0.6), Vector<3>(2, -1, -1)}) {
    const Tensor<3> V = Q * h.array().exp().matrix().asDiagonal() * Q.transpose();
    const Tensor<3> d = Q.transpose() * matrix_of<3>(SAMPLE) * Q;
    Tensor<3> excess = Tensor<3>::Zero();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const double x = h[i] - h[j];
        const double factor = std::abs(x) < 1e-3 ? x / 3 : 1 / std::tanh(x) - 1 / x;
        excess(i, j) = -factor * d(i, j);
      }
    const Vector<3> expected = axial_vector(Q * excess * Q.transpose());
    const Gradient<3> F = gradient_of(V * turn_about({0, 1, 1}, 0.9));
    expect_close(logarithmic_excess(F, SAMPLE), expected, 1, 1e-12, "excess");
  }
  EXPECT_EQ(logarithmic_excess(undeformed<3>(), SAMPLE).norm(), 0);
}

TEST(StepKinematicsInSpace, PolarRotationAndTheSpinOfARotationVector) {
  const Tensor<3> R = turn_about({1, 2, -1}, 0.7), Q = turn_about({0, 1, 3}, 0.4);
  const Tensor<3> U = Q * Vector<3>(1.4, 0.7, 1.1).asDiagonal() * Q.transpose();
  expect_close(polar_rotation(gradient_of(R * U)), R, 1, 1e-15, "R");
  for (double angle : {0.0, 0.05, 0.099, 0.11, 2.5}) { // on both sides of the series
    const Vector<3> v = angle * Vector<3>(1, 2, -1).normalized();
    const auto turn = [](const Vector<3>& of) {
      return of.norm() > 0 ? turn_about(of, of.norm()) : Tensor<3>(Tensor<3>::Identity());
    };
    Tensor<3> measured;
    for (int c = 0; c < 3; ++c)
      measured.col(c) = axial_vector(
          finite_difference([&](double t) { return turn(v + t * Vector<3>::Unit(c)); }, 0, 1e-3) *
          turn(v).transpose());
    expect_close(rotation_vector_tangent(v), measured, 1, 1e-11, "spins");
  }
}

TEST(StepKinematicsInSpace, SmallStrainsDoNotTurn) {
  const Gradient<3> F_old = gradient_in_space(0.1), F = gradient_in_space(0.4);
  const StepKinematics<3> kin = step_kinematics(F_old, F, StrainFrame::END, CorotationalRate::SMALL_STRAIN);
  expect_close(kin.strain, stress_of(mesh_part<3>(Gradient<3>(F - F_old))), 1, 1e-16, "strain");
  EXPECT_EQ(kin.R, Tensor<3>::Identity());
  EXPECT_EQ(finite_increment_by_F(kin).bottomRows<3>().norm(), 0);
  EXPECT_EQ(kin.det_mid, 1);
}

TEST(StepKinematicsInSpace, ASingularMiddleIsFlagged) {
  const Gradient<3> F = gradient_of(Vector<3>(-1, -1, 1).asDiagonal());
  EXPECT_FALSE(step_kinematics(undeformed<3>(), F, StrainFrame::END).det_mid > 0);
}
