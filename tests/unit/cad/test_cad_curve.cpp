#include "geometry/circle.hpp"
#include "unit/cad/cad_samples.hpp"
#include "unit/geometry/profile_checks.hpp"
#include <random>

using namespace burnish;
using namespace burnish::test;

namespace {

const Param<2> ANY(0.0);

/// A cam of lines and arcs, counter-clockwise, one concave corner; lengths about 5.
ArcChain cam(bool inside = false) {
  return {{{0, 0}, {6, -1}, {7, 3}, {3.2, 2.2}, {1, 5}}, {0.5, 1.1, 0.6, 0.7, 0.9}, true, inside};
}

/// Every smooth curve that gmsh can draw, with either kernel.
std::vector<std::pair<std::string, CadCurve>> curves() {
  std::vector<std::pair<std::string, CadCurve>> list;
  const std::string points = spline_points();
  const std::string shapes[] = {
      "Spline(1) = {1:5};",
      "Spline(1) = {1:9, 1};",
      "BSpline(1) = {1:5};",
      "BSpline(1) = {1:9, 1};",
      "Bezier(1) = {1:4};",
      "Point(10) = {0, 0, 0}; Point(11) = {4, 0, 0}; Point(12) = {0, 2, 0};"
      "Ellipse(1) = {11, 10, 11, 12};",
      "Point(10) = {0, 0, 0}; Point(11) = {4, 0, 0}; Point(12) = {-4*Cos(1), 4*Sin(1), 0};"
      "Circle(1) = {11, 10, 12};"};
  for (const std::string& shape : shapes)
    for (const std::string& kernel : {std::string(), std::string(OPENCASCADE)})
      list.emplace_back((kernel.empty() ? "" : "OpenCASCADE ") + shape, drawn(kernel + points + shape));
  for (const char* file : {"lobe.step", "lobe.geo", "punch.step", "punch.geo", "circle.step"})
    list.emplace_back(file, stored(file));
  return list;
}

} // namespace

TEST(CadCurve, CircleInStepAndBrepIsTheCircle) {
  for (const char* file : {"circle.step", "circle.brep", "circle.geo"})
    for (bool inside : {false, true})
      for (double scale : {1., 1e-3}) {
        SCOPED_TRACE(file);
        const CadCurve curve = stored(file, scale, inside);
        const double R = 15 * scale;
        const Circle circle(R, inside);
        ASSERT_TRUE(curve.closed());
        EXPECT_NEAR(curve.length() / (2 * M_PI * R), 1, 1e-11); // STEP files have the range to 12 digits
        EXPECT_NEAR(curve.length_scale() / R, 1, 1e-11);
        EXPECT_NEAR(curve.tightest_radius() / R, 1, 1e-12);
        for (double angle = 0.05; angle < 2 * M_PI; angle += 0.3) {
          const auto a = curve.evaluate(Param<2>(R * angle)), b = circle.evaluate(Param<2>(angle));
          expect_close(a.x, b.x, R, 1e-10, "x");
          expect_close(a.n, b.n, 1, 1e-10, "n");
          expect_close(a.x_s, b.x_s / R, 1, 1e-10, "x_s");
          expect_close(a.x_ss[0], b.x_ss[0] / (R * R), 1 / R, 1e-10, "x_ss");
          expect_close(a.n_s, b.n_s / R, 1 / R, 1e-10, "n_s");
          for (double distance : {-0.7, -0.01, 0., 0.01, 0.7}) {
            const Vector<2> x = b.x + distance * R * b.n;
            const auto c = curve.closest_point(x, Param<2>(R * angle));
            EXPECT_NEAR(c.gap / R, circle.closest_point(x, Param<2>(angle)).gap / R, 1e-10);
            EXPECT_NEAR(c.s(0) / R, angle, 1e-10);
          }
        }
      }
}

TEST(CadCurve, DerivativesAgainstFiniteDifferences) {
  for (const auto& [name, curve] : curves()) {
    SCOPED_TRACE(name);
    const double L = curve.length();
    for (double part :
         {0.031, 0.173, 0.32, 0.47, 0.568, 0.79, 0.913}) // away from the knots by 4 steps or more
      check_profile_derivatives(curve, part * L, 0.05 * curve.length_scale());
  }
}

TEST(CadCurve, FootPointsOnBothSides) {
  for (const auto& [name, curve] : curves()) {
    SCOPED_TRACE(name);
    for (double part : {0.031, 0.173, 0.32, 0.47, 0.568, 0.79, 0.913})
      for (double distance : {-0.02, -1e-6, 0., 1e-6, 0.02})
        check_foot_point(curve, part * curve.length(), distance * curve.length_scale(), curve.length_scale());
  }
}

TEST(CadCurve, ClosestPointAgainstBruteForce) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-15, 15);
  for (const auto& [name, curve] : curves()) {
    SCOPED_TRACE(name);
    const int n = 20000;
    std::vector<Vector<2>> dense;
    double spacing = 0;
    for (int i = 0; i <= n; ++i) {
      dense.push_back(curve.evaluate(Param<2>(curve.length() * i / n)).x);
      if (i > 0) spacing = std::max(spacing, (dense[i] - dense[i - 1]).norm());
    }
    for (int trial = 0; trial < 100; ++trial) {
      const Vector<2> x(uniform(random), uniform(random));
      double least = 1e9;
      for (const auto& p : dense) least = std::min(least, (x - p).norm());
      const auto foot = curve.closest_point(x, ANY);
      EXPECT_NEAR(std::abs(foot.gap), (x - curve.evaluate(foot.s).x).norm(), 1e-12);
      EXPECT_LE(std::abs(foot.gap), least + 1e-12) << x.transpose();
      EXPECT_GE(std::abs(foot.gap), least - spacing) << x.transpose();
    }
  }
}

// Against a search that knows no derivatives: 2000 places, then golden section beside the nearest one.
TEST(CadCurve, GapAgainstAFineSearch) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-15, 15);
  double worst = 0;
  for (const auto& [name, given] : curves()) {
    const auto& curve = given;
    SCOPED_TRACE(name);
    const double step = curve.length() / 2000;
    for (int trial = 0; trial < 20; ++trial) {
      const Vector<2> x(uniform(random), uniform(random));
      const auto distance = [&](double s) { return (curve.evaluate(Param<2>(s)).x - x).norm(); };
      double best = 0;
      for (int i = 0; i <= 2000; ++i)
        if (distance(i * step) < distance(best)) best = i * step;
      double low = std::max(0., best - step), high = std::min(curve.length(), best + step);
      for (const double part = (std::sqrt(5.) - 1) / 2; high - low > 1e-9 * step;) {
        const double a = high - part * (high - low), b = low + part * (high - low);
        (distance(a) > distance(b) ? low : high) = distance(a) > distance(b) ? a : b;
      }
      const double off =
          std::abs(curve.closest_point(x, ANY).gap) / std::min(distance(low), distance(best)) - 1;
      EXPECT_NEAR(off, 0, 1e-12) << x.transpose();
      worst = std::max(worst, std::abs(off));
    }
  }
  std::cout << "  gaps off by " << worst << " of the distance" << std::endl;
}

// Where several points of the same short part of a curve are almost equally near.
TEST(CadCurve, ClosestPointNearCentersOfCurvature) {
  const CadCurve curve = drawn("Point(1) = {-7.26401, 20.4627, 0}; Point(2) = {32.4234, 21.945, 0};"
                               "Point(3) = {54.7874, 23.4165, 0}; Spline(1) = {1:3};");
  const double L = curve.length();
  for (double part = 0.01; part < 1; part += 0.03) {
    const auto at = curve.evaluate(Param<2>(part * L));
    const double k = at.n.dot(at.x_ss[0]) / at.x_s.squaredNorm();
    for (const double more : {-1e-3, 0., 1e-6, 1e-3}) {
      const Vector<2> x = at.x + (1 + more) / k * at.n;
      double least = 1e9;
      for (int i = 0; i <= 4000; ++i)
        least = std::min(least, (x - curve.evaluate(Param<2>(L * i / 4000)).x).norm());
      EXPECT_LE(std::abs(curve.closest_point(x, ANY).gap) / least, 1 + 1e-8) << part << " " << more;
    }
  }
}

TEST(CadCurve, CamOfLinesAndArcsIsTheArcChain) {
  for (const char* kernel : {"", OPENCASCADE})
    for (bool inside : {false, true}) {
      const ArcChain chain = cam(inside);
      const TemporaryFile file(kernel + geo_of(chain), ".geo");
      CadSelection selection;
      selection.file = file.path();
      selection.inside = inside;
      const CadCurve curve(selection);
      ASSERT_EQ(curve.pieces().size(), chain.pieces().size());
      EXPECT_NEAR(curve.length(), chain.length(), 1e-10);
      EXPECT_NEAR(curve.tightest_radius(), chain.tightest_radius(), 1e-10);
      std::mt19937 random(5);
      std::uniform_real_distribution<double> uniform(-4, 9);
      for (int trial = 0; trial < 300; ++trial) {
        const Vector<2> x(uniform(random), uniform(random));
        const auto a = curve.closest_point(x, Param<2>(4.)), b = chain.closest_point(x, Param<2>(4.));
        EXPECT_NEAR(a.gap, b.gap, 1e-9) << x.transpose();
        const auto p = curve.evaluate(a.s), q = chain.evaluate(b.s);
        expect_close(p.x, q.x, 1, 1e-9, "foot point");
        expect_close(p.n, q.n, 1, 1e-9, "normal");
        EXPECT_NEAR(a.s(0), b.s(0), 1e-9);
      }
      for (double s = 0.01; s < chain.length(); s += 0.37) {
        const auto p = curve.evaluate(Param<2>(s)), q = chain.evaluate(Param<2>(s));
        expect_close(p.x, q.x, 1, 1e-9, "x");
        expect_close(p.x_s, q.x_s, 1, 1e-9, "x_s");
        expect_close(p.x_ss[0], q.x_ss[0], 1, 1e-8, "x_ss");
        expect_close(p.n_s, q.n_s, 1, 1e-8, "n_s");
        EXPECT_EQ(curve.piece(Param<2>(s)), chain.piece(Param<2>(s)));
      }
    }
}

TEST(CadCurve, OpenChainIsTurnedIntoOrderAndHasEnds) {
  for (const char* file : {"punch.step", "punch.geo"}) {
    const CadCurve punch = stored(file);
    ASSERT_FALSE(punch.closed());
    ASSERT_EQ(punch.pieces().size(), 4u);
    expect_close(punch.evaluate(ANY).x, Vector<2>(-10, 8), 10, 1e-12, "start");
    expect_close(punch.evaluate(Param<2>(punch.length())).x, Vector<2>(6, -0.5), 10, 1e-12, "end");
    expect_close(punch.evaluate(Param<2>(1.)).n, Vector<2>(1, 0), 1, 1e-12, "left of the first curve");
    for (double y : {9., 20.}) {
      const auto beyond = punch.closest_point({-10.5, y}, ANY);
      EXPECT_TRUE(beyond.on_end);
      EXPECT_EQ(beyond.s(0), 0);
      EXPECT_NEAR(beyond.gap, std::hypot(0.5, y - 8), 1e-12);
    }
    const auto end = punch.closest_point({9, -0.5}, ANY);
    EXPECT_TRUE(end.on_end);
    EXPECT_EQ(end.s(0), punch.length());
    EXPECT_FALSE(punch.closest_point({-9.9, 8 + 1e-13}, ANY).on_end);
    EXPECT_NEAR(punch.closest_point({-9.9, 7}, ANY).gap, 0.1, 1e-13);
    EXPECT_NEAR(punch.closest_point({-10.2, 7}, ANY).gap, -0.2, 1e-13);
  }
  const CadCurve other = stored("punch.geo", 1, true);
  EXPECT_NEAR(other.closest_point({-10.2, 7}, ANY).gap, 0.2, 1e-13);
  // the first curve given decides the direction
  const std::string text = "Point(1) = {0, 0, 0}; Point(2) = {1, 0, 0}; Point(3) = {3, 0, 0};"
                           "Line(7) = {1, 2}; Line(8) = {3, 2};";
  EXPECT_GT(drawn(text, {7, 8}).closest_point({2, 1}, ANY).gap, 0);
  EXPECT_LT(drawn(text, {8, 7}).closest_point({2, 1}, ANY).gap, 0);
  EXPECT_GT(drawn(text).closest_point({2, 1}, ANY).gap, 0);
}

TEST(CadCurve, BeyondItsEndsItGoesOnAsACircle) {
  const CadCurve punch = stored("punch.geo");
  const double L = punch.length();
  const auto end = punch.evaluate(Param<2>(L));
  const double turn = end.n_s.norm() / end.x_s.norm(), step = 1e-9;
  const auto after = punch.evaluate(Param<2>(L + step)), before = punch.evaluate(Param<2>(L - step));
  expect_close(after.x, before.x + 2 * step * end.x_s, 1, 1e-14, "x");
  expect_close(after.n, before.n + 2 * step * end.n_s, 1, 1e-14, "n");
  for (double s : {-3., -0.5, L + 0.5, L + 2}) check_profile_derivatives(punch, s, 1);
  const auto far = punch.evaluate(Param<2>(L + 2));
  EXPECT_NEAR(far.n_s.norm() / far.x_s.norm(), turn, 1e-12) << "curvature";
}

TEST(CadCurve, ParameterIsTheBranchNearestToNear) {
  const CadCurve lobe = stored("lobe.step");
  const double L = lobe.length();
  for (double s : {0.0, 0.1, 7.0, L - 1e-3})
    for (double turns : {-3., -1., 0., 2.})
      for (double off : {-0.4, 0., 0.4}) {
        const auto point = lobe.evaluate(Param<2>(s));
        const auto foot = lobe.closest_point(point.x + 0.1 * point.n, Param<2>(s + (turns + off) * L));
        EXPECT_NEAR(foot.s(0), s + turns * L, 1e-11);
        expect_close(lobe.evaluate(foot.s).x, point.x, 1, 1e-11, "periodic");
        EXPECT_EQ(lobe.piece(foot.s), 0);
      }
}

TEST(CadCurve, TightestRadius) {
  EXPECT_NEAR(
      drawn("Point(1)={0,0,0}; Point(2)={3,0,0}; Point(3)={0,1,0}; Ellipse(1)={2,1,2,3};").tightest_radius(),
      1. / 3, 1e-10); // b^2/a at the end of the long axis
  EXPECT_EQ(drawn("Point(1)={0,0,0}; Point(2)={3,1,0}; Line(1)={1,2};").tightest_radius(),
            std::numeric_limits<double>::infinity());
  // parabola y = x^2: 1/2 in the middle
  EXPECT_NEAR(drawn("Point(1)={-1,1,0}; Point(2)={-1/3,-1/3,0}; Point(3)={1/3,-1/3,0}; Point(4)={1,1,0};"
                    "Bezier(1)={1,2,3,4};")
                  .tightest_radius(),
              0.5, 1e-10);
}
