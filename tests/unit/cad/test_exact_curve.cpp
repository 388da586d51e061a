// Curves of OpenCASCADE against their definitions in extended precision.
#include "cad/occ/cad_edge.hpp"
#include "cad/occ/exact_curve.hpp"
#include "unit/cad/spline_reference.hpp"
#include "unit/finite_difference.hpp"
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_Line.hxx>
#include <Geom_OffsetCurve.hxx>
#include <Geom_Parabola.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <gp_Ax2.hxx>
#include <random>

using namespace burnish;
using namespace burnish::test;

namespace {

CadEdge edge_of(const Handle(Geom_Curve) & curve, double begin, double end) {
  CadEdge edge;
  edge.kind = "curve";
  edge.curve = curve;
  edge.begin = begin;
  edge.end = end;
  return edge;
}

/// Largest errors of x, x_u, x_uu at 400 places, each relative to the largest of its kind.
template <class Reference>
void check(const CadEdge& edge, const Reference& reference, double tolerance, double of_derivatives) {
  const ExactCurve curve(edge, "curve");
  double error[3] = {0, 0, 0}, largest[3] = {0, 0, 0};
  for (int i = 0; i < 400; ++i) {
    const double u = edge.begin + (edge.end - edge.begin) * (i + 0.37) / 400;
    const auto computed = curve.evaluate(u);
    const Jet expected = reference(u);
    const Vector<3> values[] = {computed.x, computed.first, computed.second};
    for (std::size_t k = 0; k < 3; ++k) {
      const Real dx = values[k].x() - expected[k][0], dy = values[k].y() - expected[k][1];
      error[k] = std::max(error[k], static_cast<double>(std::hypot(dx, dy)));
      largest[k] = std::max(largest[k], static_cast<double>(std::hypot(expected[k][0], expected[k][1])));
      EXPECT_EQ(values[k].z(), 0);
    }
  }
  EXPECT_LE(error[0], tolerance * largest[0]) << "x";
  EXPECT_LE(error[1], of_derivatives * largest[1]) << "x_u";
  EXPECT_LE(error[2], of_derivatives * largest[2]) << "x_uu";
}

/// A spline as OpenCASCADE has it, and by its definition.
struct Spline {
  Spline(int degree, int spans, bool rational, unsigned seed = 1) : degree(degree) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> part(0, 1);
    knots = {0};
    for (int i = 0; i < spans; ++i) knots.push_back(knots.back() + 0.1 + part(random));
    repeated.assign(knots.size(), 1);
    repeated.front() = repeated.back() = degree + 1;
    for (int i = 0; i < degree + spans; ++i) {
      poles.push_back({3.0 * i + part(random), 10 * part(random)});
      weights.push_back(rational ? 0.5 + 3.5 * part(random) : 1);
    }
  }
  Handle(Geom_BSplineCurve) curve() const {
    TColgp_Array1OfPnt p(1, static_cast<int>(poles.size()));
    for (std::size_t i = 0; i < poles.size(); ++i)
      p(static_cast<int>(i) + 1) =
          gp_Pnt(static_cast<double>(poles[i][0]), static_cast<double>(poles[i][1]), 0);
    TColStd_Array1OfReal w(1, p.Length()), k(1, static_cast<int>(knots.size()));
    TColStd_Array1OfInteger m(1, k.Length());
    std::copy(weights.begin(), weights.end(), w.begin());
    std::copy(knots.begin(), knots.end(), k.begin());
    std::copy(repeated.begin(), repeated.end(), m.begin());
    return new Geom_BSplineCurve(p, w, k, m, degree);
  }
  SplineReference reference() const {
    std::vector<Real> all, w(weights.begin(), weights.end());
    for (std::size_t i = 0; i < knots.size(); ++i)
      for (int k = 0; k < repeated[i]; ++k) all.push_back(knots[i]);
    return {degree, poles, w, all};
  }
  double end() const { return knots.back(); }

  int degree;
  std::vector<RealPoint> poles;
  std::vector<double> weights, knots;
  std::vector<int> repeated;
};

Real turned_x(Real x, Real y) { return 3 + 0.6L * x - 0.8L * y; }
Real turned_y(Real x, Real y) { return -2 + 0.8L * x + 0.6L * y; }
/// Frame at (3, -2), turned by atan(4/3).
gp_Ax2 frame() { return {gp_Pnt(3, -2, 0), gp_Dir(0, 0, 1), gp_Dir(3, 4, 0)}; }
Jet turned(const std::array<Real, 6>& v) {
  const auto direction = [](Real x, Real y) { return RealPoint{0.6L * x - 0.8L * y, 0.8L * x + 0.6L * y}; };
  return {RealPoint{turned_x(v[0], v[1]), turned_y(v[0], v[1])},
          direction(v[2], v[3]),
          direction(v[4], v[5]),
          {}};
}

} // namespace

TEST(ExactCurve, LinesAndConics) {
  check(
      edge_of(new Geom_Line(gp_Pnt(3, -2, 0), gp_Dir(3, 4, 0)), -5, 20),
      [](Real u) {
        return turned({u, 0, 1, 0, 0, 0});
      },
      1e-15, 1e-15);
  check(
      edge_of(new Geom_Circle(frame(), 15), 0.3, 6.5),
      [](Real u) {
        const Real c = 15 * std::cos(u), s = 15 * std::sin(u);
        return turned({c, s, -s, c, -c, -s});
      },
      1e-15, 1e-15);
  for (const double b : {2., 0.004}) // 1000 times as long as wide, too
    check(
        edge_of(new Geom_Ellipse(frame(), 4, b), -1, 5),
        [b](Real u) {
          const Real c = std::cos(u), s = std::sin(u);
          return turned({4 * c, b * s, -4 * s, b * c, -4 * c, -b * s});
        },
        1e-15, 1e-15);
  check(
      edge_of(new Geom_Hyperbola(frame(), 3, 2), -1, 1.5),
      [](Real u) {
        const Real c = std::cosh(u), s = std::sinh(u);
        return turned({3 * c, 2 * s, 3 * s, 2 * c, 3 * c, 2 * s});
      },
      1e-15, 1e-15);
  check(
      edge_of(new Geom_Parabola(frame(), 2), -4, 5),
      [](Real u) {
        return turned({u * u / 8, u, u / 4, 1, 0.25L, 0});
      },
      1e-15, 1e-15);
}

TEST(ExactCurve, Splines) {
  for (const int degree : {1, 2, 3, 5, 9})
    for (const bool rational : {false, true}) {
      SCOPED_TRACE(std::to_string(degree) + (rational ? ", rational" : ""));
      const Spline spline(degree, 30, rational);
      const SplineReference reference = spline.reference();
      const auto expected = [&](Real u) { return reference.at(u); };
      const double end = spline.end(), tolerance = rational ? 1e-14 : 2e-15;
      check(edge_of(spline.curve(), 0, end), expected, tolerance, 10 * tolerance);
      check(edge_of(spline.curve(), 0.3 * end, 0.8 * end), expected, tolerance, 10 * tolerance);
    }
}

// The adaptors of OpenCASCADE are wrong by 1e-8 here.
TEST(ExactCurve, BezierCurvesOfHighDegree) {
  for (const int degree : {3, 12, 21, 25}) {
    SCOPED_TRACE(degree);
    const Spline spline(degree, 1, false);
    TColgp_Array1OfPnt poles(1, degree + 1);
    for (int i = 0; i <= degree; ++i) poles(i + 1) = spline.curve()->Pole(i + 1);
    const Handle(Geom_BezierCurve) curve = new Geom_BezierCurve(poles);
    std::vector<Real> knots(static_cast<std::size_t>(degree) + 1, 0);
    knots.resize(2 * knots.size(), 1);
    const SplineReference reference(degree, spline.poles, std::vector<Real>(spline.poles.size(), 1), knots);
    check(
        edge_of(curve, 0, 1), [&](Real u) { return reference.at(u); }, 1e-15, 3e-15);
  }
}

TEST(ExactCurve, AtADistance) {
  const Handle(Geom_OffsetCurve) circle =
      new Geom_OffsetCurve(new Geom_Circle(frame(), 15), 3, gp_Dir(0, 0, 1));
  check(
      edge_of(circle, 0.3, 6.5),
      [](Real u) {
        const Real c = 18 * std::cos(u), s = 18 * std::sin(u);
        return turned({c, s, -s, c, -c, -s});
      },
      1e-15, 1e-15);
  const Spline spline(4, 12, false);
  const SplineReference reference = spline.reference();
  const Handle(Geom_OffsetCurve) beside_it = new Geom_OffsetCurve(spline.curve(), -0.7, gp_Dir(0, 0, 1));
  const CadEdge edge = edge_of(beside_it, 0, spline.end());
  check(
      edge, [&](Real u) { return beside(reference.at(u), -0.7L); }, 1e-14, 1e-13);
  // at a knot the derivatives of each side
  const ExactCurve curve(edge, "curve");
  ASSERT_EQ(curve.knots().size(), 13u);
  for (std::size_t i = 1; i < 12; ++i) {
    const double u = curve.knots()[i];
    for (const bool before : {true, false}) {
      const Jet expected = beside(reference.at(u, i + (before ? 3 : 4)), -0.7L);
      const auto value = curve.evaluate(u, before);
      expect_close(value.second.head<2>(),
                   Vector<2>(static_cast<double>(expected[2][0]), static_cast<double>(expected[2][1])), 100,
                   1e-12, "x_uu");
    }
  }
}

TEST(ExactCurve, EachSideOfAKnot) {
  for (const int degree : {2, 3, 6}) {
    const Spline spline(degree, 20, false);
    const SplineReference reference = spline.reference();
    const ExactCurve curve(edge_of(spline.curve(), 0, spline.end()), "curve");
    ASSERT_EQ(curve.knots().size(), 21u);
    for (std::size_t i = 0; i <= 20; ++i)
      for (const bool before : {true, false}) {
        const auto value = curve.evaluate(curve.knots()[i], before);
        const std::size_t span = std::min<std::size_t>(
            std::max<std::size_t>(i, before || i == 20 ? 1 : 0) - (before || i == 20 ? 1 : 0), 19);
        const Jet expected = reference.at(spline.knots[i], span + static_cast<std::size_t>(degree));
        for (std::size_t k = 0; k < 2; ++k) {
          EXPECT_NEAR(value.x[static_cast<int>(k)], static_cast<double>(expected[0][k]), 1e-13);
          EXPECT_NEAR(value.first[static_cast<int>(k)], static_cast<double>(expected[1][k]), 1e-12);
          EXPECT_NEAR(value.second[static_cast<int>(k)], static_cast<double>(expected[2][k]), 2e-11);
        }
      }
  }
}

// Edges of closed curves may begin anywhere, and run over the place where the spline begins.
TEST(ExactCurve, PeriodicSplines) {
  const int n = 9;
  TColgp_Array1OfPnt poles(1, n);
  TColStd_Array1OfReal knots(1, n + 1);
  TColStd_Array1OfInteger repeated(1, n + 1);
  std::vector<RealPoint> all;
  std::vector<Real> all_knots;
  for (int i = 0; i < n; ++i)
    poles(i + 1) = gp_Pnt(10 * std::cos(0.7 * i), 8 * std::sin(0.7 * i) + 0.1 * i, 0);
  for (int i = 0; i <= n; ++i) {
    knots(i + 1) = i + 0.3 * std::sin(i);
    repeated(i + 1) = 1;
  }
  const Handle(Geom_BSplineCurve) curve = new Geom_BSplineCurve(poles, knots, repeated, 3, true);
  const double first = curve->FirstParameter(), period = curve->Period();
  // three periods, with all knots and poles written down
  const Handle(Geom_BSplineCurve) open = Handle(Geom_BSplineCurve)::DownCast(curve->Copy());
  open->SetNotPeriodic();
  std::vector<RealPoint> p;
  std::vector<Real> t;
  for (int i = 1; i <= open->NbPoles(); ++i) p.push_back({open->Pole(i).X(), open->Pole(i).Y()});
  for (int i = 1; i <= open->NbKnots(); ++i)
    for (int k = 0; k < open->Multiplicity(i); ++k) t.push_back(open->Knot(i));
  const SplineReference reference(3, p, std::vector<Real>(p.size(), 1), t);
  for (const double from : {0., 0.25, 1.7, -3.1, 20.2}) {
    SCOPED_TRACE(from);
    const double begin = first + from;
    check(
        edge_of(curve, begin, begin + period),
        [&](Real u) { return reference.at(u - period * std::floor((u - first) / period)); }, 3e-15, 1e-14);
  }
}

TEST(ExactCurve, WithoutACurve) {
  CadEdge none;
  none.missing = "has no curve in space";
  expect_invalid([&] { ExactCurve(none, "curve 3"); }, "CadCurve: curve 3 has no curve in space");
  const Handle(Geom_Curve) line = new Geom_Line(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0));
  for (const auto& [begin, end] : {std::make_pair(0., 0.), {1., 0.}, {0., std::nan("")}, {-2e100, 2e100}})
    expect_invalid([&, a = begin, b = end] { ExactCurve(edge_of(line, a, b), "curve 3"); },
                   "curve 3 has no range of its parameter: its points are not finite or fall together");
}
