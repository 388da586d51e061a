#include "cad/occ/geo_drawing.hpp"
#include "cad/occ/geo_statement.hpp"
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Ax2.hxx>

namespace burnish {

namespace {

using Points = std::vector<gp_XYZ>;

CadEdge edge_of(Geom_Curve* curve, double begin, double end) {
  CadEdge edge;
  edge.curve = curve;
  edge.begin = begin;
  edge.end = end;
  return edge;
}

/// A spline from its poles and its knots, each with how often it is repeated.
CadEdge spline(const Points& poles, int degree, const std::vector<double>& knots,
               const std::vector<int>& repeated) {
  TColgp_Array1OfPnt p(1, static_cast<int>(poles.size()));
  for (std::size_t i = 0; i < poles.size(); ++i) p(static_cast<int>(i) + 1) = gp_Pnt(poles[i]);
  TColStd_Array1OfReal k(1, static_cast<int>(knots.size()));
  TColStd_Array1OfInteger m(1, static_cast<int>(knots.size()));
  std::copy(knots.begin(), knots.end(), k.begin());
  std::copy(repeated.begin(), repeated.end(), m.begin());
  return edge_of(new Geom_BSplineCurve(p, k, m, degree), knots.front(), knots.back());
}

/// n equal spans from 0 to 1; inner knots are repeated, end knots fill up.
CadEdge equal_spans(const Points& poles, int degree, int n, int repeated) {
  std::vector<double> knots;
  for (int i = 0; i <= n; ++i) knots.push_back(static_cast<double>(i) / n);
  std::vector<int> times(knots.size(), repeated);
  times.front() = times.back() = degree + 1;
  return spline(poles, degree, knots, times);
}

CadEdge line(const Points& x) {
  const double length = (x.back() - x.front()).Modulus();
  if (x.size() > 2 || !(length > 0 && std::isfinite(length)))
    return equal_spans(x, 1, static_cast<int>(x.size()) - 1, 1);
  return edge_of(new Geom_Line(x[0], gp_Dir(x[1] - x[0])), 0, length);
}

bool is_closed(const std::vector<int>& points) {
  return points.front() == points.back() && points.size() > 2;
}

// Each span as a Bezier cubic; neighbors share a pole.
CadEdge catmull_rom(const Points& x, bool closed) {
  const std::size_t n = x.size();
  Points poles{x[0]};
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const gp_XYZ before = i > 0 ? x[i - 1] : closed ? x[n - 2] : 2 * x[0] - x[1];
    const gp_XYZ after = i + 2 < n ? x[i + 2] : closed ? x[1] : 2 * x[n - 1] - x[n - 2];
    poles.push_back(x[i] + (x[i + 1] - before) / 6);
    poles.push_back(x[i + 1] - (after - x[i]) / 6);
    poles.push_back(x[i + 1]);
  }
  return equal_spans(poles, 3, static_cast<int>(n) - 1, 3);
}

CadEdge uniform_cubic(const Points& x, bool closed) {
  const int n = static_cast<int>(x.size());
  if (!closed) return equal_spans(x, std::min(3, n - 1), std::max(1, n - 3), 1);
  Points poles;
  const auto at = [&](int i) { return x[static_cast<std::size_t>((i + n - 1) % (n - 1))]; };
  poles.push_back((at(-1) + 4 * at(0) + at(1)) / 6);
  for (int i = 0; i + 1 < n; ++i) {
    poles.push_back((2 * at(i) + at(i + 1)) / 3);
    poles.push_back((at(i) + 2 * at(i + 1)) / 3);
    poles.push_back((at(i) + 4 * at(i + 1) + at(i + 2)) / 6);
  }
  return equal_spans(poles, 3, n - 1, 3);
}

CadEdge bezier(const Points& x) {
  TColgp_Array1OfPnt poles(1, static_cast<int>(x.size()));
  for (std::size_t i = 0; i < x.size(); ++i) poles(static_cast<int>(i) + 1) = gp_Pnt(x[i]);
  return edge_of(new Geom_BezierCurve(poles), 0, 1);
}

CadEdge nurbs(const Points& x, const GeoStatement& drawn) {
  std::vector<double> knots;
  std::vector<int> repeated;
  for (const double knot : drawn.knots) {
    if (!knots.empty() && knot == knots.back()) {
      ++repeated.back();
    } else {
      knots.push_back(knot);
      repeated.push_back(1);
    }
  }
  return spline(x, drawn.order, knots, repeated);
}

// The angle of the end, counted on from that of the begin.
double angle_after(double begin, double end) { return end > begin ? end : end + 2 * M_PI; }

CadEdge circle(const Points& x, const gp_Pnt& middle) {
  const gp_XYZ start = x[0] - x[1], end = x[2] - x[1];
  const gp_Dir axis(start.Crossed(middle.XYZ() - x[1])), along(start);
  const gp_Ax2 frame(x[1], axis, along);
  const double angle = std::atan2(end.Dot(frame.YDirection().XYZ()), end.Dot(frame.XDirection().XYZ()));
  return edge_of(new Geom_Circle(frame, start.Modulus()), 0, angle_after(0, angle));
}

// a x^2 + b y^2 = 1 at both ends, in a frame with the given axis.
CadEdge ellipse(const Points& x, const gp_Pnt& middle) {
  const gp_XYZ start = x[0] - x[1], end = x[3] - x[1];
  gp_Ax2 frame(x[1], gp_Dir(start.Crossed(middle.XYZ() - x[1])), gp_Dir(x[2] - x[1]));
  const auto in_frame = [&](const gp_XYZ& d) {
    return gp_XY(d.Dot(frame.XDirection().XYZ()), d.Dot(frame.YDirection().XYZ()));
  };
  gp_XY p = in_frame(start), q = in_frame(end);
  const double determinant = p.X() * p.X() * q.Y() * q.Y() - p.Y() * p.Y() * q.X() * q.X();
  double first = std::sqrt(determinant / (q.Y() * q.Y() - p.Y() * p.Y())),
         second = std::sqrt(determinant / (p.X() * p.X() - q.X() * q.X()));
  if (first < second) { // OpenCASCADE wants the long axis first
    frame = gp_Ax2(x[1], frame.Direction(), frame.YDirection());
    p = in_frame(start);
    q = in_frame(end);
    std::swap(first, second);
  }
  const double begin = std::atan2(p.Y() / second, p.X() / first);
  return edge_of(new Geom_Ellipse(frame, first, second), begin,
                 angle_after(begin, std::atan2(q.Y() / second, q.X() / first)));
}

CadEdge curve_of(const GeoStatement& drawn, const Points& x, const gp_Pnt& middle) {
  const bool closed = is_closed(drawn.points);
  if (x.size() < 2) return {};
  if (drawn.word == "Line") return line(x);
  if (drawn.word == "Circle" && x.size() == 3) return circle(x, middle);
  if (drawn.word == "Ellipse" && x.size() == 4) return ellipse(x, middle);
  if (drawn.word == "Spline") return catmull_rom(x, closed);
  if (drawn.word == "BSpline") return uniform_cubic(x, closed);
  if (drawn.word == "Bezier") return bezier(x);
  if (drawn.word == "Nurbs") return nurbs(x, drawn);
  return {};
}

} // namespace

std::map<int, CadEdge> drawn_curves(const std::string& unrolled, const std::map<int, gp_Pnt>& middles) {
  std::map<int, gp_XYZ> points;
  std::map<int, CadEdge> edges;
  for (const GeoStatement& drawn : geo_statements(unrolled)) {
    if (drawn.word == "Point" && drawn.numbers.size() >= 3)
      points[drawn.tag] = {drawn.numbers[0], drawn.numbers[1], drawn.numbers[2]};
    const auto middle = middles.find(drawn.tag);
    if (drawn.word == "Point" || middle == middles.end()) continue;
    Points x;
    for (const int point : drawn.points)
      if (points.count(point)) x.push_back(points[point]);
    if (x.size() != drawn.points.size()) continue;
    try {
      CadEdge edge = curve_of(drawn, x, middle->second);
      edge.kind = drawn.word;
      edges[drawn.tag] = edge;
    } catch (const Standard_Failure&) { // of more than 26 points, radii that are not finite, ...
    }
  }
  return edges;
}

} // namespace burnish
