#include "geometry/arc_chain.hpp"
#include "geometry/circle.hpp"
#include "geometry/segment.hpp"
#include "unit/geometry/profile_checks.hpp"
#include <limits>
#include <random>

using namespace burnish;
using namespace burnish::test;

namespace {

using Points = std::vector<Vector<2>>;
const Param<2> ANY(0.0);

Points scaled(Points points, double unit) {
  for (auto& p : points) p *= unit;
  return points;
}
std::vector<double> scaled(std::vector<double> radii, double unit) {
  for (auto& r : radii) r *= unit;
  return radii;
}

/// A punch, open: down its side, a fillet, the flat, a concave fillet, a step up to the right.
const Points PUNCH{{-4, 3}, {-4, 0}, {1, 0}, {1.5, 2}, {5, 2.5}};
const std::vector<double> PUNCH_RADII{0, 0.8, 0.4, 0.9, 0};
ArcChain punch(double unit, bool inside = false) {
  return {scaled(PUNCH, unit), scaled(PUNCH_RADII, unit), false, inside};
}
/// A cam, closed, counter-clockwise, one concave corner.
const Points CAM{{0, 0}, {6, -1}, {7, 3}, {3.2, 2.2}, {1, 5}};
const std::vector<double> CAM_RADII{0.5, 1.1, 0.6, 0.7, 0.9};
ArcChain cam(double unit, bool inside = false) {
  return {scaled(CAM, unit), scaled(CAM_RADII, unit), true, inside};
}
/// Joints of a chain: where each piece begins, and the end.
std::vector<double> joints(const ArcChain& chain) {
  std::vector<double> s{0};
  for (const ArcPiece& piece : chain.pieces()) s.push_back(s.back() + piece.length);
  return s;
}

} // namespace

TEST(ArcChain, DerivativesAgainstFiniteDifferencesOnEveryPiece) {
  for (double unit : {1e-3, 1.0, 1e4})
    for (bool inside : {false, true})
      for (const ArcChain& chain : {punch(unit, inside), cam(unit, inside)}) {
        const auto s = joints(chain);
        for (std::size_t i = 0; i + 1 < s.size(); ++i)
          for (double part : {0.2, 0.5, 0.8})
            check_profile_derivatives(chain, s[i] + part * (s[i + 1] - s[i]), chain.length_scale() / 10);
      }
}

TEST(ArcChain, BeyondTheEndsItGoesOnSmoothly) {
  const ArcChain chain = punch(1), arc({{-1, 0}, {0, 0.1}, {1, 0}}, {0, 10, 0});
  for (const ArcChain* c : {&chain, &arc})
    for (double s : {-0.5, -0.1, c->length() + 0.1, c->length() + 0.5})
      check_profile_derivatives(*c, s, c->length_scale() / 10);
  expect_close(chain.evaluate(Param<2>(-2.0)).x, Vector<2>(-4, 5), 1, 1e-15, "beyond the start");
}

TEST(ArcChain, JointsAreContinuousInPointTangentAndNormal) {
  for (const ArcChain& chain : {punch(1), cam(1), cam(1, true)})
    for (double s : joints(chain)) {
      const auto before = chain.evaluate(Param<2>(s - 1e-13)), after = chain.evaluate(Param<2>(s + 1e-13));
      expect_close(before.x, after.x, 1, 1e-12, "x");
      expect_close(before.x_s, after.x_s, 1, 1e-12, "x_s");
      expect_close(before.n, after.n, 1, 1e-12, "n");
    }
}

TEST(ArcChain, PiecesBeginAtTheirJoints) {
  const ArcChain open = punch(1), closed = cam(1);
  ASSERT_EQ(open.pieces().size(), 7u);
  ASSERT_EQ(closed.pieces().size(), 10u);
  const auto s = joints(open);
  for (int i = 0; i < 7; ++i) {
    EXPECT_EQ(open.piece(Param<2>(s[i])), i);
    EXPECT_EQ(open.piece(Param<2>((s[i] + s[i + 1]) / 2)), i);
  }
  EXPECT_EQ(open.piece(Param<2>(-1.0)), 0);
  EXPECT_EQ(open.piece(Param<2>(s[7] + 1)), 6);
  const double L = closed.length(), middle = joints(closed)[3] + 1e-3;
  for (double turns : {-2., 0., 1.}) EXPECT_EQ(closed.piece(Param<2>(middle + turns * L)), 3);
}

TEST(ArcChain, BodyIsLeftOfOpenAndOutsideOfClosedChains) {
  // the punch runs down and to the right: the body is left of it
  EXPECT_GT(punch(1).closest_point({-3, 1}, ANY).gap, 0);
  EXPECT_LT(punch(1, true).closest_point({-3, 1}, ANY).gap, 0);
  Points clockwise(CAM.rbegin(), CAM.rend());
  std::vector<double> radii(CAM_RADII.rbegin(), CAM_RADII.rend());
  for (bool inside : {false, true})
    for (const ArcChain& chain : {cam(1, inside), ArcChain(clockwise, radii, true, inside)}) {
      const double sign = inside ? -1 : 1;
      EXPECT_GT(sign * chain.closest_point({-2, 1}, ANY).gap, 0);
      EXPECT_LT(sign * chain.closest_point({2, 1}, ANY).gap, 0);
      EXPECT_GT(sign * chain.evaluate(chain.closest_point({3, -5}, ANY).s).n.y(), -1);
      EXPECT_LT(sign * chain.evaluate(chain.closest_point({3, -5}, ANY).s).n.y(), 0);
    }
}

TEST(ArcChain, FootPointsOnBothSides) {
  for (double unit : {1e-3, 1.0})
    for (const ArcChain& chain : {punch(unit), punch(unit, true), cam(unit), cam(unit, true)}) {
      const auto s = joints(chain);
      for (std::size_t i = 0; i + 1 < s.size(); ++i)
        for (double part : {0.01, 0.5, 0.99})
          for (double distance : {-0.2, -1e-6, 0.0, 1e-6, 0.2}) // less than every radius: unique
            check_foot_point(chain, s[i] + part * (s[i + 1] - s[i]), distance * unit, chain.length_scale());
    }
}

// Nearest of 40 000 points of the chain, against points anywhere around it.
TEST(ArcChain, ClosestPointAgainstBruteForce) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-6, 10);
  for (const ArcChain& chain : {punch(1), cam(1)}) {
    const int n = 40000;
    Points dense;
    for (int i = 0; i <= n; ++i) dense.push_back(chain.evaluate(Param<2>(chain.length() * i / n)).x);
    const double spacing = chain.length() / n;
    for (int trial = 0; trial < 200; ++trial) {
      const Vector<2> x(uniform(random), uniform(random));
      double least = 1e9;
      for (const auto& p : dense) least = std::min(least, (x - p).norm());
      const auto foot = chain.closest_point(x, ANY);
      EXPECT_NEAR(std::abs(foot.gap), (x - chain.evaluate(foot.s).x).norm(), 1e-13);
      EXPECT_LE(std::abs(foot.gap), least + 1e-13) << x.transpose();
      EXPECT_GE(std::abs(foot.gap), least - spacing) << x.transpose();
    }
  }
}

TEST(ArcChain, EndsAsThoseOfASegment) {
  const ArcChain chain({{0, 0}, {1, 0}, {2, 0}}, {0, 0, 0}); // a collinear point is no corner
  const Segment segment({0, 0}, {2, 0});
  ASSERT_EQ(chain.pieces().size(), 2u);
  for (double x : {-3., -1e-9, 0., 0.4, 1., 1.7, 2., 2 + 1e-14, 2 + 1e-9, 5.})
    for (double y : {-4., -0.1, 0., 0.1, 4.}) {
      const auto a = chain.closest_point({x, y}, ANY), b = segment.closest_point({x, y}, ANY);
      EXPECT_NEAR(a.s(0), b.s(0), 1e-15) << x << " " << y;
      EXPECT_NEAR(a.gap, b.gap, 1e-15) << x << " " << y;
      EXPECT_EQ(a.on_end, b.on_end) << x << " " << y;
    }
}

TEST(ArcChain, FourFilletsThatUseUpTheirLinesAreACircle) {
  const double R = 15e-3;
  const ArcChain chain({{R, R}, {-R, R}, {-R, -R}, {R, -R}}, {R, R, R, R}, true);
  ASSERT_EQ(chain.pieces().size(), 4u);
  EXPECT_NEAR(chain.length() / R, 2 * M_PI, 1e-14);
  EXPECT_NEAR(chain.length_scale() / R, 1, 1e-14);
  const Circle circle(R);
  for (double angle = -10; angle < 10; angle += 0.37)
    for (double distance : {0.2, 0.9, 1.0, 1.3}) {
      const Vector<2> x = distance * R * Vector<2>(std::cos(angle), std::sin(angle));
      const auto a = chain.closest_point(x, Param<2>(R * angle)),
                 b = circle.closest_point(x, Param<2>(angle));
      EXPECT_NEAR(a.gap / R, b.gap / R, 1e-14);
      expect_close(chain.evaluate(a.s).x, circle.evaluate(b.s).x, R, 1e-13, "foot point");
      expect_close(chain.evaluate(a.s).n, circle.evaluate(b.s).n, 1, 1e-13, "normal");
    }
}

// Crowned punch: one fillet uses up both its lines; a flat arc whose radius is 1000 times its width.
TEST(ArcChain, OnePureArc) {
  const double width = 0.02, R = 20, h = 0.5 * width, rise = h * h / std::sqrt(R * R - h * h);
  const ArcChain crown({{-h, 0}, {0, -rise}, {h, 0}}, {0, R, 0});
  ASSERT_EQ(crown.pieces().size(), 1u);
  const double half = std::asin(h / R);
  EXPECT_NEAR(crown.length() / (2 * R * half), 1, 1e-10);
  EXPECT_DOUBLE_EQ(crown.tightest_radius(), R);
  const double sag = R - std::sqrt(R * R - h * h);
  EXPECT_NEAR(crown.closest_point({0, 0}, ANY).gap / sag, 1, 1e-9);
  EXPECT_NEAR(crown.closest_point({0, -1.5 * sag}, ANY).gap / sag, -0.5, 1e-9);
  const auto end = crown.closest_point({h + 1e-3, 0}, ANY);
  EXPECT_TRUE(end.on_end);
  EXPECT_NEAR(end.gap, 1e-3, 1e-15);
  for (double part : {0.1, 0.5, 0.9})
    for (double distance : {-1e-3, 0., 1e-3}) check_foot_point(crown, part * crown.length(), distance, width);
}

TEST(ArcChain, ParameterIsTheBranchNearestToNear) {
  const ArcChain chain = cam(1);
  const double L = chain.length();
  for (double s : {0.0, 0.1, 7.0, L - 1e-3})
    for (double turns : {-3., -1., 0., 2.})
      for (double off : {-0.4, 0., 0.4}) {
        const auto point = chain.evaluate(Param<2>(s));
        const auto foot = chain.closest_point(point.x + 0.1 * point.n, Param<2>(s + (turns + off) * L));
        EXPECT_NEAR(foot.s(0), s + turns * L, 1e-12);
        expect_close(chain.evaluate(foot.s).x, point.x, 1, 1e-12, "periodic");
      }
}

TEST(ArcChain, OfEqualFootPointsTheNearerParameter) {
  const ArcChain channel({{0, 5}, {0, 0}, {4, 0}, {4, 5}}, {0, 1, 1, 0});
  const Vector<2> middle(2, 4); // as far from either wall
  EXPECT_NEAR(channel.closest_point(middle, Param<2>(0.5)).s(0), 1, 1e-14);
  EXPECT_NEAR(channel.closest_point(middle, Param<2>(9.)).s(0), channel.length() - 1, 1e-14);
  const Vector<2> center(1, 1); // of the first fillet: the parameter stays
  EXPECT_NEAR(channel.closest_point(center, Param<2>(4.5)).s(0), 4.5, 1e-14);
  EXPECT_NEAR(channel.closest_point(center, ANY).s(0), 4, 1e-14);
}

TEST(ArcChain, LengthsAndRadii) {
  const ArcChain square({{0, 0}, {4, 0}, {4, 2}, {0, 2}}, {0.5, 0.5, 0.25, 0.5}, true);
  EXPECT_NEAR(square.length(), 12 - 2 * 3.25 * 0.5 - 0.25 + (0.75 + 0.125) * M_PI, 1e-14);
  EXPECT_DOUBLE_EQ(square.tightest_radius(), 0.25);
  EXPECT_TRUE(square.range().closed);
  EXPECT_DOUBLE_EQ(square.range().end(0), square.length());
  EXPECT_FALSE(punch(1).range().closed);
  EXPECT_DOUBLE_EQ(punch(1e-3).tightest_radius(), 0.4e-3);
  EXPECT_DOUBLE_EQ(punch(1).length_scale(), punch(1).length());
  EXPECT_EQ(ArcChain({{0, 0}, {1, 1}}, {0, 0}).tightest_radius(), std::numeric_limits<double>::infinity());
  // a radius without a corner rounds nothing
  EXPECT_EQ(ArcChain({{0, 0}, {1, 1}, {2, 2}}, {0, 9, 0}).tightest_radius(),
            std::numeric_limits<double>::infinity());
}

TEST(ArcChain, SameInMetersAndMillimeters) {
  const ArcChain meters = cam(1e-3), millimeters = cam(1);
  const Vector<2> x(8e-3, 5e-3);
  const auto in_m = meters.closest_point(x, Param<2>(5e-3)),
             in_mm = millimeters.closest_point(1e3 * x, Param<2>(5.));
  EXPECT_NEAR(1e3 * in_m.s(0), in_mm.s(0), 1e-13);
  EXPECT_NEAR(1e3 * in_m.gap, in_mm.gap, 1e-13);
}
