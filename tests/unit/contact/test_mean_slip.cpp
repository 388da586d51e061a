// The slip of a step along the mean of its directions, METHOD.md (3.14g), (3.14h).
#include "contact/mean_slip.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

Param<3> at_angle(double size, double angle) { return size * Param<3>(std::cos(angle), std::sin(angle)); }

} // namespace

TEST(MeanSlip, SlipLiesAlongTheWeightedMean) {
  for (const double w : {0.01, 0.4, 0.98})
    for (const double angle : {-1.5, -0.4, 0., 0.9, 2.5}) {
      const Param<3> D = at_angle(0.7, 0.3 + angle), memory = at_angle(w, 0.3);
      const Param<3> m = mean_slip<3>(D, memory).way / 0.7;
      EXPECT_NEAR(m.norm(), 1, 1e-14);
      const Param<3> mean = memory + m;
      EXPECT_NEAR(mean[0] * D[1] - mean[1] * D[0], 0, 1e-14) << w << " " << angle;
      EXPECT_GE(mean.dot(D), 0) << w << " " << angle;
    }
}

TEST(MeanSlip, TurnsTwiceWithAWholeMemoryNotAtAllWithoutOne) {
  const double angle = 0.2;
  const Param<3> D = at_angle(0.3, angle);
  const Param<3> turned = mean_slip<3>(D, at_angle(1, 0)).way;
  EXPECT_NEAR(std::atan2(turned[1], turned[0]), 2 * angle, 1e-14);
  EXPECT_EQ(mean_slip<3>(D, Param<3>::Zero()).way, D);
  EXPECT_EQ(mean_slip<3>(D, Param<3>::Zero()).by_slip, Curvature<3>(Curvature<3>::Identity()));
  const Param<3> none = Param<3>::Zero(), back = at_angle(1, M_PI);
  EXPECT_EQ(mean_slip<3>(none, at_angle(0.5, 0)).way, none);
  EXPECT_NEAR((mean_slip<3>(back, at_angle(0.5, 0)).way - back).norm(), 0, 1e-14) << "a slip back stays one";
}

TEST(MeanSlip, LongSlipsForget) {
  EXPECT_EQ(slip_memory(0, 2, 0.1), 1);
  EXPECT_DOUBLE_EQ(slip_memory(1, 2, 0.1), 0.5) << "kappa = c/0.05 = 2: as much as g";
  EXPECT_NEAR(slip_memory(1e6, 2, 0.1), 0, 1e-11);
  EXPECT_EQ(slip_memory(1, 0, 0.1), 0) << "nothing presses";
}

TEST(MeanSlip, DerivativeByDifferences) {
  for (const double w : {0.1, 0.6, 0.95})
    for (const double angle : {-1., 0.1, 1.4}) {
      const Param<3> D = at_angle(0.4, 0.3 + angle), memory = at_angle(w, 0.3);
      const Curvature<3> exact = mean_slip<3>(D, memory).by_slip;
      for (int k = 0; k < 2; ++k) {
        const Param<3> step = 1e-6 * Param<3>::Unit(k);
        const Param<3> change =
            (mean_slip<3>(D + step, memory).way - mean_slip<3>(D - step, memory).way) / 2e-6;
        EXPECT_NEAR((change - exact.col(k)).norm(), 0, 1e-8) << w << " " << angle;
      }
    }
}
