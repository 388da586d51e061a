// Curves of gmsh's built-in kernel against their formulas in extended precision, from the points alone.
#include "cad/occ/geo_drawing.hpp"
#include "cad/occ/geo_statement.hpp"
#include "unit/cad/cad_samples.hpp"
#include "unit/cad/spline_reference.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

const std::vector<RealPoint> POINTS{{12.5L, 0}, {9, 7},   {2, 11},    {-5, 8}, {-8.25L, 3},
                                    {-9, -4},   {-3, -7}, {4, -9.5L}, {10, -6}};

std::string points_text() {
  std::ostringstream text;
  for (std::size_t i = 0; i < POINTS.size(); ++i)
    text << "Point(" << i + 1 << ") = {" << static_cast<double>(POINTS[i][0]) << ", "
         << static_cast<double>(POINTS[i][1]) << ", 0};\n";
  return text.str();
}

/// x, x_s, x_ss along a curve against a reference in u from 0 to 1, at its knots from both sides; spans: of equal u.
template <class Reference>
void check(const std::string& drawing, int spans, const Reference& reference, double tolerance) {
  SCOPED_TRACE(drawing);
  const CadCurve curve = drawn(points_text() + drawing);
  const double L = curve.length();
  for (int span = 0; span < spans; ++span)
    for (const double part : {0.01, 0.3, 0.77, 0.99}) {
      const double u = (span + part) / spans;
      const Jet expected = reference(u, span);
      const auto at = curve.evaluate(Param<2>(u * L));
      for (int c = 0; c < 2; ++c) {
        const auto k = static_cast<std::size_t>(c);
        EXPECT_NEAR(at.x[c], static_cast<double>(expected[0][k]), 10 * tolerance);
        EXPECT_NEAR(at.x_s(c, 0) * L, static_cast<double>(expected[1][k]), 100 * spans * tolerance);
        EXPECT_NEAR(at.x_ss[0](c, 0) * L * L, static_cast<double>(expected[2][k]),
                    1000 * spans * spans * tolerance);
      }
    }
}

/// Four points, a matrix of coefficients of t^3, t^2, t, 1.
Jet cubic(const std::array<RealPoint, 4>& p, const Real (&matrix)[4][4], Real u, int span, int spans) {
  const Real t = u * spans - span, rate = spans;
  Jet x{};
  for (std::size_t c = 0; c < 2; ++c) {
    Real a[4] = {0, 0, 0, 0};
    for (int i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j) a[i] += matrix[i][j] * p[j][c];
    x[0][c] = ((a[0] * t + a[1]) * t + a[2]) * t + a[3];
    x[1][c] = rate * ((3 * a[0] * t + 2 * a[1]) * t + a[2]);
    x[2][c] = rate * rate * (6 * a[0] * t + 2 * a[1]);
  }
  return x;
}

const Real CATMULL_ROM[4][4] = {
    {-0.5L, 1.5L, -1.5L, 0.5L}, {1, -2.5L, 2, -0.5L}, {-0.5L, 0, 0.5L, 0}, {0, 1, 0, 0}};
const Real UNIFORM[4][4] = {{-1 / 6.L, 0.5L, -0.5L, 1 / 6.L},
                            {0.5L, -1, 0.5L, 0},
                            {-0.5L, 0, 0.5L, 0},
                            {1 / 6.L, 4 / 6.L, 1 / 6.L, 0}};

RealPoint beyond(const RealPoint& a, const RealPoint& b) { return {2 * a[0] - b[0], 2 * a[1] - b[1]}; }

} // namespace

TEST(GeoDrawing, SplineIsCatmullRom) {
  for (const int n : {2, 3, 6}) {
    const auto reference = [n](Real u, int span) {
      const auto at = [&](int i) {
        const auto k = static_cast<std::size_t>(i);
        return i < 0    ? beyond(POINTS[0], POINTS[1])
               : i == n ? beyond(POINTS[k - 1], POINTS[k - 2])
                        : POINTS[k];
      };
      return cubic({at(span - 1), at(span), at(span + 1), at(span + 2)}, CATMULL_ROM, u, span, n - 1);
    };
    check("Spline(1) = {1:" + std::to_string(n) + "};", n - 1, reference, 3e-15);
  }
  const auto closed = [](Real u, int span) {
    const auto at = [](int i) { return POINTS[static_cast<std::size_t>((i + 9) % 9)]; };
    return cubic({at(span - 1), at(span), at(span + 1), at(span + 2)}, CATMULL_ROM, u, span, 9);
  };
  check("Spline(1) = {1:9, 1};", 9, closed, 3e-15);
}

TEST(GeoDrawing, BSplineHasEqualKnots) {
  for (const int n : {2, 3, 4, 5, 6, 9}) {
    const int degree = std::min(3, n - 1), spans = std::max(1, n - 3);
    std::vector<Real> knots(static_cast<std::size_t>(degree), 0);
    for (int i = 0; i <= spans; ++i) knots.push_back(static_cast<Real>(i) / spans);
    knots.insert(knots.end(), static_cast<std::size_t>(degree), 1);
    const SplineReference spline(degree, {POINTS.begin(), POINTS.begin() + n},
                                 std::vector<Real>(static_cast<std::size_t>(n), 1), knots);
    check(
        "BSpline(1) = {1:" + std::to_string(n) + "};", spans, [&](Real u, int) { return spline.at(u); },
        3e-15);
  }
  const auto closed = [](Real u, int span) {
    const auto at = [](int i) { return POINTS[static_cast<std::size_t>((i + 9) % 9)]; };
    return cubic({at(span - 1), at(span), at(span + 1), at(span + 2)}, UNIFORM, u, span, 9);
  };
  check("BSpline(1) = {1:9, 1};", 9, closed, 3e-15);
}

TEST(GeoDrawing, BezierAndNurbs) {
  const auto bezier = [](int n) {
    std::vector<Real> knots(static_cast<std::size_t>(n), 0);
    knots.resize(2 * knots.size(), 1);
    return SplineReference(n - 1, {POINTS.begin(), POINTS.begin() + n},
                           std::vector<Real>(static_cast<std::size_t>(n), 1), knots);
  };
  for (const int n : {2, 4, 9}) {
    const SplineReference spline = bezier(n);
    check(
        "Bezier(1) = {1:" + std::to_string(n) + "};", 1, [&](Real u, int) { return spline.at(u); }, 3e-15);
  }
  const SplineReference nurbs(3, {POINTS.begin(), POINTS.begin() + 7}, std::vector<Real>(7, 1),
                              {0, 0, 0, 0, 0.25L, 0.5L, 0.75L, 1, 1, 1, 1});
  check(
      "Nurbs(1) = {1:7} Knots {0,0,0,0,0.25,0.5,0.75,1,1,1,1} Order 3;", 4,
      [&](Real u, int) { return nurbs.at(u); }, 3e-15);
}

// Clockwise, counterclockwise, halves either way, turned and mirrored.
TEST(GeoDrawing, Circles) {
  struct Arc {
    std::string text;
    Real x, y, begin, angle;
  };
  const std::string center = "Point(20) = {1, 2, 0}; Point(21) = {6, 2, 0}; ";
  const Real pi = std::acos(-1.L);
  const Arc arcs[] = {
      {center + "Point(22) = {1, 7, 0}; Circle(1) = {21, 20, 22};", 1, 2, 0, pi / 2},
      {center + "Point(22) = {1, -3, 0}; Circle(1) = {21, 20, 22};", 1, 2, 0, -pi / 2},
      {center + "Point(22) = {-4, 2, 0}; Circle(1) = {21, 20, 22};", 1, 2, 0, pi},
      {center + "Point(22) = {-4, 2, 0}; Circle(1) = {21, 20, 22} Plane{0, 0, -1};", 1, 2, 0, -pi},
      {center + "Point(22) = {-3, 5, 0}; Circle(1) = {22, 20, 21};", 1, 2, std::atan2(3.L, -4.L),
       -std::atan2(3.L, -4.L)},
      {center + "Point(22) = {1, 7, 0}; Circle(1) = {21, 20, 22}; Symmetry {1, 0, 0, 0} {Curve{1};}", -1, 2,
       pi, -pi / 2},
      {center +
           "Point(22) = {1, 7, 0}; Circle(1) = {21, 20, 22}; Rotate {{0, 0, 1}, {0, 0, 0}, Pi} {Curve{1};}",
       -1, -2, pi, pi / 2}};
  for (const Arc& arc : arcs)
    check(
        arc.text, 1,
        [&](Real u, int) {
          const Real c = 5 * std::cos(arc.begin + arc.angle * u), s = 5 * std::sin(arc.begin + arc.angle * u),
                     a = arc.angle;
          return Jet{RealPoint{arc.x + c, arc.y + s}, {-a * s, a * c}, {-a * a * c, -a * a * s}, {}};
        },
        3e-15);
}

// gmsh's own values are off by 1e-8 at the ends of the axes.
TEST(GeoDrawing, Ellipses) {
  const std::string points = "Point(20) = {1, 2, 0}; Point(21) = {5, 2, 0}; Point(22) = {1, 4, 0};";
  // quarter from the long axis to the short one; the axis is given by any point on either axis
  for (const char* axis : {"21", "22"})
    check(
        points + "Ellipse(1) = {21, 20, " + axis + ", 22};", 1,
        [](Real u, int) {
          const Real h = std::acos(-1.L) / 2, c = std::cos(h * u), s = std::sin(h * u);
          return Jet{
              RealPoint{1 + 4 * c, 2 + 2 * s}, {-h * 4 * s, h * 2 * c}, {-h * h * 4 * c, -h * h * 2 * s}, {}};
        },
        3e-15);
  // back over the short axis
  const CadCurve back =
      drawn(points + "Point(23) = {1 - 4*Cos(0.5), 2 + 2*Sin(0.5), 0}; Ellipse(1) = {23, 20, 21, 21};");
  for (double part = 0.05; part < 1; part += 0.1) {
    const Vector<2> x = back.evaluate(Param<2>(part * back.length())).x;
    EXPECT_NEAR(std::hypot((x.x() - 1) / 4, (x.y() - 2) / 2), 1, 1e-15);
    EXPECT_GE(x.y(), 2);
  }
}

TEST(GeoDrawing, LinesThroughSeveralPoints) {
  expect_invalid([] { drawn(points_text() + "Line(1) = {1:3};"); }, "curve 1 (Line) of");
  const CadCurve straight =
      drawn("Point(1) = {0, 0, 0}; Point(2) = {1, 1, 0}; Point(3) = {2, 2, 0}; Line(1) = {1:3};");
  EXPECT_NEAR(straight.length(), std::sqrt(8), 3e-15);
}

TEST(GeoDrawing, BothKernelsInOneFile) {
  const CadCurve curve =
      drawn("Point(1) = {0, 0, 0}; Point(2) = {1, 0, 0}; Line(1) = {1, 2};\nSetFactory(\"OpenCASCADE\");\n"
            "Circle(7) = {1, 1, 0, 1, -Pi/2, 0};");
  ASSERT_EQ(curve.pieces().size(), 2u);
  EXPECT_NEAR(curve.length(), 1 + M_PI / 2, 1e-14);
  EXPECT_EQ(curve.pieces()[1].tag(), 7);
}

// Curves of OpenCASCADE keep their tags, whatever belongs to surfaces and solids.
TEST(GeoDrawing, TagsOfOpenCascade) {
  const std::string text =
      std::string(OPENCASCADE) +
      "Rectangle(1) = {0, 0, 0, 10, 5, 1}; Disk(2) = {5, 2.5, 0, 1};"
      "BooleanDifference(3) = {Surface{1}; Delete;}{Surface{2}; Delete;};"
      "Box(7) = {20, 0, 0, 1, 1, 1}; Circle(50) = {0, 0, 0, 3}; Circle(40) = {0, 0, 0, 4};";
  EXPECT_NEAR(drawn(text, {50}).tightest_radius(), 3, 1e-14);
  EXPECT_NEAR(drawn(text, {40}).tightest_radius(), 4, 1e-14);
  EXPECT_NEAR(drawn(text, {9}).tightest_radius(), 1, 1e-14) << "the hole";
  EXPECT_NEAR(drawn(text, {1, 2, 3, 4, 5, 6, 7, 8}).length(), 2 * 8 + 2 * 3 + 2 * M_PI, 1e-12);
}

TEST(GeoStatement, WhatGmshWrites) {
  const auto all = geo_statements(
      "cl__1 = 1e+22;\nPoint(3) = {1.5, -2e-3, nan, cl__1};\nSpline(14) = {1, 2, 3, 4, 5, 6, 7, 8\n"
      ", 9};\nNurbs(2) = {1, 2}\n  Knots {0, 0,\n   1, 1}\n  Order 1;\n"
      "Physical Curve(\"top\", 3) = {1};\nTransfinite Line {1} = 3;\nField[1] = Box;\nLine(5) = {1, 2");
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].word, "Point");
  EXPECT_EQ(all[0].tag, 3);
  EXPECT_EQ(all[0].numbers[1], -2e-3);
  EXPECT_TRUE(std::isnan(all[0].numbers[2]));
  EXPECT_EQ(all[1].points, (std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(all[2].knots, (std::vector<double>{0, 0, 1, 1}));
  EXPECT_EQ(all[2].order, 1);
  EXPECT_TRUE(geo_statements("").empty());
}

TEST(GeoDrawing, WhatCannotBeDrawn) {
  std::string many = "For i In {1:30}\n Point(i) = {i, Sin(i), 0};\nEndFor\n";
  expect_invalid(
      [&] { drawn(many + "Bezier(1) = {1:30};"); },
      "is none that can be evaluated exactly; draw it with another kind of curve, or use SetFactory");
}
