#include "material/j2/rate_law.hpp"
#include "unit/material/j2/point_walk.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {
const Stress<2> DIRECTION = {1, -0.2, -0.8, 0.9};
/// d_xx, d_yy, d_zz, d_xy, w_21
Eigen::Matrix<double, 5, 1> rates(double spin) {
  Eigen::Matrix<double, 5, 1> y;
  y << 0.7, -0.3, 0.1, 0.2, spin;
  return y;
}
} // namespace

TEST(RateLaw, LoadingTest) {
  const J2Parameters material = example_material();
  const Stress<2> s = on_surface(material, DIRECTION, 0.1);
  EXPECT_TRUE(loads<2>(material, s, 0.1, DIRECTION));
  EXPECT_TRUE(loads<2>(material, (1 - 1e-12) * s, 0.1, DIRECTION)); // rounding
  EXPECT_FALSE(loads<2>(material, (1 - 1e-6) * s, 0.1, DIRECTION)); // inside
  EXPECT_FALSE(loads<2>(material, s, 0.1, -DIRECTION));             // unloads
}

TEST(RateLaw, StressStaysOnTheHardeningSurface) { // s:(D:d) 3/(2q) = H' ep', ep' = 3G (s:d)/(q (3G + H'))
  for (double H : {0.0, 9.62e8, 3e10}) {
    const J2Parameters material = example_material(1.93e8, H);
    const double G = material.elastic.G;
    const Stress<2> s = on_surface(material, DIRECTION, 0.1);
    const auto y = rates(0.9);
    const Stress<2> d = y.head<4>(), rate = rate_moduli<2>(material, s, 0.1, true) * y;
    const double q = equivalent<2>(s), rate_q = 1.5 * contract<2>(s, rate) / q;
    const double rate_plastic_strain_eq = 3 * G * contract<2>(s, d) / (q * (3 * G + H));
    EXPECT_NEAR(rate_q, H * rate_plastic_strain_eq, 1e-12 * G) << "H' = " << H;
  }
}

TEST(RateLaw, ElasticModuli) {
  const J2Parameters material = example_material();
  const auto y = rates(0);
  const Stress<2> rate = rate_moduli<2>(material, DIRECTION, 0, false) * y;
  const double G = material.elastic.G, pressure = material.elastic.K * 0.5, third = 0.5 / 3;
  const Stress<2> expected = {pressure + 2 * G * (0.7 - third), pressure - 2 * G * (0.3 + third),
                              pressure + 2 * G * (0.1 - third), 2 * G * 0.2};
  expect_close(rate, expected, G, 1e-14, "E:d");
  EXPECT_EQ(rate_moduli<2>(material, Stress<2>::Zero(), 0, true),
            rate_moduli<2>(material, Stress<2>::Zero(), 0, false));
}

TEST(ForwardEuler, StaysElasticToTheEndOfTheStepThatCrossesTheSurface) {
  PointWalk step;
  step.scheme.update = StressUpdate::FORWARD_EULER;
  const J2End<2> now = step.at(tensor(1.02, 0, 0, 1));
  EXPECT_FALSE(now.plastic);
  EXPECT_GT(equivalent<2>(deviator<2>(now.stress)), 2 * step.material.yield_stress(0).value);
}

TEST(ForwardEuler, LeavesTheSurfaceByTheSquareOfTheStep) {
  PointWalk step;
  step.scheme.update = StressUpdate::FORWARD_EULER;
  step.old.stress = on_surface(step.material, DIRECTION, 0);
  double before = 0;
  for (double size : {2e-4, 1e-4, 5e-5}) {
    const J2End<2> now = step.at(tensor(1 + size, 0, size, 1)); // not along s
    ASSERT_TRUE(now.plastic);
    const double q = equivalent<2>(deviator<2>(now.stress));
    const double excess = q - step.material.yield_stress(now.plastic_strain_eq).value;
    EXPECT_GT(excess, 0);
    if (before > 0) {
      EXPECT_NEAR(before / excess, 4, 0.1) << "step " << size;
    }
    before = excess;
  }
}

TEST(ForwardEuler, AlongTheStressItIsExact) {
  PointWalk step;
  const Tensor<2> F = tensor(1.001, 0, 0, 0.999);
  step.old.stress = on_surface(step.material, step.kinematics(F).strain, 0);
  step.scheme.update = StressUpdate::FORWARD_EULER;
  const J2End<2> euler = step.at(F);
  step.scheme.update = StressUpdate::SINGLE;
  const J2End<2> single = step.at(F);
  ASSERT_TRUE(euler.plastic);
  expect_close(euler.stress, single.stress, single.stress.norm(), 1e-12, "stress");
  EXPECT_NEAR(euler.plastic_strain_eq, single.plastic_strain_eq, 1e-15);
}
