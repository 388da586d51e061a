#include "geometry/segment.hpp"
#include "unit/geometry/profile_checks.hpp"
#include <limits>

using namespace burnish;
using namespace burnish::test;

namespace {
const Param<2> ANY(0.0);
/// From (1,1) to (5,4): L = 5, t = (0.8, 0.6), n = (-0.6, 0.8); times a unit of length.
Segment sloped(double unit) { return {unit * Vector<2>(1, 1), unit * Vector<2>(5, 4)}; }
} // namespace

TEST(Segment, DerivativesAgainstFiniteDifferencesAlsoBeyondTheEnds) {
  for (double unit : {1e-3, 1.0, 1e4})
    for (double s : {-3.0, 0.0, 1.7, 5.0, 9.0}) check_profile_derivatives(sloped(unit), s * unit, 5 * unit);
}

TEST(Segment, EndsAndNormalToTheLeft) {
  const Segment segment = sloped(1);
  EXPECT_DOUBLE_EQ(segment.length(), 5);
  EXPECT_DOUBLE_EQ(segment.length_scale(), 5);
  expect_close(segment.evaluate(Param<2>(0.0)).x, Vector<2>(1, 1), 1, 1e-15, "x(0)");
  expect_close(segment.evaluate(Param<2>(5.0)).x, Vector<2>(5, 4), 1, 1e-15, "x(L)");
  expect_close(segment.evaluate(Param<2>(2.0)).n, Vector<2>(-0.6, 0.8), 1, 1e-15, "n");
  const Segment swapped(segment.b(), segment.a());
  expect_close(swapped.evaluate(Param<2>(2.0)).n, Vector<2>(0.6, -0.8), 1, 1e-15, "n of b -> a");
}

TEST(Segment, GoesOnLinearlyBeyondTheEnds) {
  const Segment segment = sloped(1);
  expect_close(segment.evaluate(Param<2>(10.0)).x, Vector<2>(9, 7), 1, 1e-15, "x(2L)");
  expect_close(segment.evaluate(Param<2>(-5.0)).x, Vector<2>(-3, -2), 1, 1e-15, "x(-L)");
}

TEST(Segment, FootPointOnBothSides) {
  for (double unit : {1e-3, 1.0})
    for (double s : {0.0, 1e-3, 2.5, 5.0})
      for (double distance : {-20.0, -1e-6, 0.0, 1e-6, 20.0})
        check_foot_point(sloped(unit), s * unit, distance * unit, 5 * unit);
}

TEST(Segment, BeyondAnEndTheGapIsThePositiveDistance) {
  const Segment segment({0, 0}, {2, 0});
  for (double y : {4.0, 0.0, -4.0}) { // outside, in line, and behind: never penetrating
    const auto right = segment.closest_point({5, y}, ANY);
    EXPECT_TRUE(right.on_end);
    EXPECT_DOUBLE_EQ(right.s(0), 2);
    EXPECT_DOUBLE_EQ(right.gap, std::hypot(3, y));
    const auto left = segment.closest_point({-3, y}, ANY);
    EXPECT_TRUE(left.on_end);
    EXPECT_DOUBLE_EQ(left.s(0), 0);
    EXPECT_DOUBLE_EQ(left.gap, std::hypot(3, y));
  }
}

TEST(Segment, GapAcrossTheNormalAtAnEnd) {
  const Segment segment({0, 0}, {2, 0});
  const double d = 1e-9;
  // outside: continuous
  EXPECT_NEAR(segment.closest_point({2 - d, 0.5}, ANY).gap, 0.5, 1e-15);
  EXPECT_NEAR(segment.closest_point({2 + d, 0.5}, ANY).gap, 0.5, 1e-15);
  // behind: from penetrating to free
  EXPECT_NEAR(segment.closest_point({2 - d, -0.5}, ANY).gap, -0.5, 1e-15);
  EXPECT_NEAR(segment.closest_point({2 + d, -0.5}, ANY).gap, 0.5, 1e-15);
  EXPECT_FALSE(segment.closest_point({2 - d, 0.5}, ANY).on_end);
  EXPECT_TRUE(segment.closest_point({2 + d, 0.5}, ANY).on_end);
}

TEST(Segment, RoundingAtAnEndIsNotBeyondIt) {
  for (double unit : {1e-3, 1.0, 1e3}) {
    const Segment segment({0, 0}, {2 * unit, 0});
    const auto closest = segment.closest_point({2 * unit * (1 + 1e-14), -0.5 * unit}, ANY);
    EXPECT_FALSE(closest.on_end);
    EXPECT_EQ(closest.s(0), 2 * unit);
    EXPECT_NEAR(closest.gap / unit, -0.5, 1e-15);
  }
}

TEST(Segment, SameInMetersAndMillimeters) {
  for (const Vector<2>& x : {Vector<2>(3, 1), Vector<2>(7, 2), Vector<2>(2, 6)}) {
    const auto in_m = sloped(1e-3).closest_point(1e-3 * x, ANY);
    const auto in_mm = sloped(1).closest_point(x, ANY);
    EXPECT_NEAR(1000 * in_m.s(0), in_mm.s(0), 1e-14);
    EXPECT_NEAR(1000 * in_m.gap, in_mm.gap, 1e-14);
    EXPECT_EQ(in_m.on_end, in_mm.on_end);
  }
}

TEST(Segment, RefusesBadInput) {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  expect_invalid(
      [] {
        Segment({1, 2}, {1, 2});
      },
      "Segment: length |b - a| = 0, expected a finite number > 0");
  expect_invalid([&] { Segment({nan, 2}, {1, 2}); }, "Segment: a = nan   2, expected finite components");
  expect_invalid([&] { Segment({1, 2}, {inf, 2}); }, "Segment: b = inf   2, expected finite components");
  const Segment segment = sloped(1);
  expect_invalid([&] { segment.evaluate(Param<2>(nan)); }, "Segment::evaluate: s = nan");
  expect_invalid([&] { segment.closest_point({nan, 0}, ANY); }, "Segment::closest_point: x = nan   0");
}
