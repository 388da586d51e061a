// The slip of a step along the mean of its directions, METHOD.md (3.14g), (3.14h).
#include "contact/mean_slip.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

Param<3> at_angle(double size, double angle) { return size * Param<3>(std::cos(angle), std::sin(angle)); }
constexpr double REACH = 2;

} // namespace

TEST(MeanSlip, SlipLiesAlongTheWeightedMean) {
  for (const double size : {0.02, 0.7, 2., 30.})
    for (const double angle : {-1.5, -0.4, 0., 0.9, 2.5}) {
      const Param<3> D = at_angle(size, 0.3 + angle), before = at_angle(1, 0.3);
      const Param<3> m = mean_slip<3>(D, before, REACH).way / size;
      EXPECT_NEAR(m.norm(), 1, 1e-14);
      const double w = 1 / (1 + size * size / (REACH * REACH));
      const Param<3> mean = w * before + m;
      EXPECT_NEAR(mean[0] * D[1] - mean[1] * D[0], 0, 1e-13 * size) << size << " " << angle;
      EXPECT_GE(mean.dot(D), 0) << size << " " << angle;
    }
}

TEST(MeanSlip, ShortSlipsTurnTwiceLongOnesNotAtAll) {
  const double angle = 0.2;
  const Param<3> before = at_angle(1, 0);
  const Param<3> brief = mean_slip<3>(at_angle(1e-4, angle), before, REACH).way / 1e-4;
  EXPECT_NEAR(std::atan2(brief[1], brief[0]), 2 * angle, 1e-8);
  const Param<3> wide = mean_slip<3>(at_angle(1e4, angle), before, REACH).way / 1e4;
  EXPECT_NEAR(std::atan2(wide[1], wide[0]), angle, 1e-7);
  const Param<3> back = mean_slip<3>(at_angle(1, M_PI), before, REACH).way;
  EXPECT_NEAR((back - at_angle(1, M_PI)).norm(), 0, 1e-14) << "a slip back stays one";
}

TEST(MeanSlip, NothingTurnsWithoutADirectionBefore) {
  const Param<3> D = at_angle(0.3, 1);
  for (const auto& mean : {mean_slip<3>(D, Param<3>::Zero(), REACH), mean_slip<3>(D, Param<3>(1, 0), 0)}) {
    EXPECT_EQ(mean.way, D);
    EXPECT_EQ(mean.by_slip, Curvature<3>(Curvature<3>::Identity()));
  }
  EXPECT_EQ(mean_slip<3>(Param<3>::Zero(), Param<3>(1, 0), REACH).way, Param<3>(Param<3>::Zero()));
}

TEST(MeanSlip, DerivativeByDifferences) {
  for (const double size : {0.1, 1., 5.})
    for (const double angle : {-1., 0.1, 1.4}) {
      const Param<3> D = at_angle(size, 0.3 + angle), before = at_angle(1, 0.3);
      const Curvature<3> exact = mean_slip<3>(D, before, REACH).by_slip;
      for (int k = 0; k < 2; ++k) {
        const double h = 1e-6 * size;
        const Param<3> step = h * Param<3>::Unit(k);
        const Param<3> change =
            (mean_slip<3>(D + step, before, REACH).way - mean_slip<3>(D - step, before, REACH).way) / (2 * h);
        EXPECT_NEAR((change - exact.col(k)).norm(), 0, 1e-8) << size << " " << angle;
      }
    }
}
