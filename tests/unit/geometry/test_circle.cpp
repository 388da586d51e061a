#include "geometry/circle.hpp"
#include "unit/geometry/profile_checks.hpp"
#include <limits>

using namespace burnish;
using namespace burnish::test;

namespace {
const double ANGLES[] = {-9.0, -M_PI, -1.2, 0.0, 0.4, M_PI_2, 3.0, M_PI, 12.5};
}

TEST(Circle, DerivativesAgainstFiniteDifferences) {
  for (double radius : {15e-3, 15.0, 2e4})
    for (bool inside : {false, true}) {
      SCOPED_TRACE("radius " + std::to_string(radius) + (inside ? " inside" : " outside"));
      for (double s : ANGLES) check_profile_derivatives(Circle(radius, inside), s, 1);
    }
}

TEST(Circle, PointsAndNormals) {
  const double R = 15;
  for (bool inside : {false, true}) {
    const ProfilePoint<2> top = Circle(R, inside).evaluate(Param<2>(M_PI_2));
    expect_close(top.x, Vector<2>(0, R), R, 1e-15, "x");
    expect_close(top.x_s, Vector<2>(-R, 0), R, 1e-15, "x_s");
    expect_close(top.n, Vector<2>(0, inside ? -1 : 1), 1, 1e-15, "n");
  }
}

TEST(Circle, WrittenFormulaOfSecondDerivative) { // METHOD.md 2.3: X_ss = -R n for n out of the circle
  const Circle circle(15);
  for (double s : ANGLES) {
    const ProfilePoint<2> point = circle.evaluate(Param<2>(s));
    expect_close(point.x_ss[0], -15 * point.n, 15, 1e-15, "x_ss");
  }
}

TEST(Circle, FootPointOnBothSides) {
  const double R = 15e-3;
  for (bool inside : {false, true})
    for (double s : ANGLES) // up to 0.8 R toward the center, where the foot point is still this one
      for (double ratio : {-0.8, -1e-6, 0.0, 1e-6, 0.8}) check_foot_point(Circle(R, inside), s, ratio * R, 1);
}

TEST(Circle, SignOfGap) {
  const Param<2> near(0.0);
  EXPECT_DOUBLE_EQ(Circle(2).closest_point({3, 0}, near).gap, 1);
  EXPECT_DOUBLE_EQ(Circle(2).closest_point({0, -0.5}, near).gap, -1.5);
  EXPECT_DOUBLE_EQ(Circle(2, true).closest_point({3, 0}, near).gap, -1);
  EXPECT_DOUBLE_EQ(Circle(2, true).closest_point({0, -0.5}, near).gap, 1.5);
}

TEST(Circle, ParameterIsTheBranchNearestToNear) {
  const Circle circle(2);
  for (double angle : ANGLES)
    for (double near : {-50.0, -3.2, 0.0, 3.1, 100.0}) {
      const Vector<2> x(5 * std::cos(angle), 5 * std::sin(angle));
      const double s = circle.closest_point(x, Param<2>(near)).s(0);
      EXPECT_LE(std::abs(s - near), M_PI + 1e-13) << "angle " << angle << " near " << near;
      expect_close(circle.evaluate(Param<2>(s)).x * 2.5, x, 5, 1e-13, "foot point on the ray");
    }
}

TEST(Circle, RollingNodeKeepsAContinuousParameter) {
  const Circle circle(2);
  Param<2> s(0.0);
  const double step = 0.3;
  for (int i = 1; i <= 100; ++i) { // almost five turns, clockwise
    const double angle = -i * step;
    s = circle.closest_point({3 * std::cos(angle), 3 * std::sin(angle)}, s).s;
    ASSERT_NEAR(s(0), angle, 1e-12);
  }
}

TEST(Circle, CenterKeepsTheParameter) {
  for (bool inside : {false, true}) {
    const ClosestPoint<2> closest = Circle(2, inside).closest_point({0, 0}, Param<2>(7.5));
    EXPECT_EQ(closest.s(0), 7.5);
    EXPECT_EQ(closest.gap, inside ? 2 : -2);
    EXPECT_FALSE(closest.on_end);
  }
}

TEST(Circle, SameInMetersAndMillimeters) {
  const Circle meters(15e-3), millimeters(15);
  const Vector<2> x(7e-3, -16e-3);
  const auto in_m = meters.closest_point(x, Param<2>(5.0));
  const auto in_mm = millimeters.closest_point(1000 * x, Param<2>(5.0));
  EXPECT_NEAR(in_m.s(0), in_mm.s(0), 1e-14);
  EXPECT_NEAR(1000 * in_m.gap, in_mm.gap, 1e-14);
  expect_close(1000 * meters.evaluate(in_m.s).x_s, millimeters.evaluate(in_mm.s).x_s, 15, 1e-14, "x_s");
  EXPECT_DOUBLE_EQ(1000 * meters.length_scale(), millimeters.length_scale());
}

TEST(Circle, RefusesBadInput) {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  expect_invalid([] { Circle(0.0); }, "Circle: radius = 0, expected a finite number > 0");
  expect_invalid([] { Circle(-1.5); }, "Circle: radius = -1.5");
  expect_invalid([&] { Circle{nan}; }, "Circle: radius = nan");
  expect_invalid([&] { Circle{inf}; }, "Circle: radius = inf");
  const Circle circle(1);
  expect_invalid([&] { circle.evaluate(Param<2>(nan)); },
                 "Circle::evaluate: s = nan, expected a finite angle");
  expect_invalid(
      [&] {
        circle.closest_point({1, nan}, Param<2>(0.0));
      },
      "Circle::closest_point: x =   1 nan, expected finite components");
  expect_invalid([&] { circle.closest_point({1, 0}, Param<2>(inf)); }, "Circle::closest_point: near = inf");
}
