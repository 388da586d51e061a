#include "cad/occ/cad_curve.hpp"
#include "base/error.hpp"
#include "cad/occ/cad_crossings.hpp"
#include "geometry/arc_piece.hpp"
#include "geometry/plane.hpp"
#include <algorithm>

namespace burnish {

namespace {

double curvature(const CadValue& value) {
  return std::abs(cross(value.first, value.second)) / std::pow(value.first.norm(), 3);
}

std::vector<double> starts(const std::vector<CadPiece>& pieces) {
  std::vector<double> start{0};
  for (const CadPiece& piece : pieces) start.push_back(start.back() + piece.length());
  return start;
}

// Beyond an end: the circle of curvature (or line) at constant speed.
CadValue beyond(const CadValue& end, double s) {
  const double speed = end.first.norm();
  const ArcPiece arc{end.x, end.first / speed, cross(end.first, end.second) / std::pow(speed, 3), speed};
  const Vector<2> t = arc.direction(speed * s);
  return {arc.point(speed * s), speed * t, speed * speed * arc.curvature * left_of(t)};
}

} // namespace

CadCurve::CadCurve(const CadSelection& selection) : CadCurve(read_curves(selection), selection.inside) {}

CadCurve::CadCurve(const std::vector<CadPiece>& curves, bool inside)
    : m_chain(chained(curves)), m_start(starts(m_chain.pieces)), m_search(m_chain.pieces) {
  check_crossings(m_chain, m_search.cells());
  m_side = closed() && counterclockwise() ? -1 : 1;
  if (inside) m_side = -m_side;
  m_tightest = 1 / sharpest();
}

bool CadCurve::counterclockwise() const {
  double area = 0;
  const Vector<2> origin = m_search.cells()[0].x[0];
  for (const CadCell& cell : m_search.cells())
    area += cross(Vector<2>(cell.x[0] - origin), Vector<2>(cell.x[1] - origin));
  return area > 0;
}

// Largest curvature: of samples, then refined around the best one by golden section.
double CadCurve::sharpest() const {
  const CadCell* best = nullptr;
  double at = 0, step = 0, most = 0;
  for (const CadCell& cell : m_search.cells())
    for (int k = 0; k <= 8; ++k) {
      const double s = cell.begin + (cell.end - cell.begin) * (k == 0 ? 1e-9 : k == 8 ? 1 - 1e-9 : k / 8.);
      const double value = curvature(pieces()[cell.piece].at(s));
      if (value <= most) continue;
      most = value;
      best = &cell;
      at = s;
      step = (cell.end - cell.begin) / 8;
    }
  if (!best || most * length() < 1e-9) return 0; // straight
  double low = std::max(at - step, best->begin), high = std::min(at + step, best->end);
  const double golden = (std::sqrt(5.) - 1) / 2;
  for (int round = 0; round < 60; ++round) {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    const double left = curvature(pieces()[best->piece].at(a)),
                 right = curvature(pieces()[best->piece].at(b));
    most = std::max({most, left, right});
    (left > right ? high : low) = left > right ? b : a;
  }
  return most;
}

double CadCurve::wrapped(double s) const { return closed() ? s - length() * std::floor(s / length()) : s; }

std::size_t CadCurve::piece_at(double wrapped_s) const {
  const auto next = std::upper_bound(m_start.begin() + 1, m_start.end() - 1, wrapped_s);
  return static_cast<std::size_t>(next - m_start.begin() - 1);
}

int CadCurve::piece(const Param<2>& s) const {
  require(s.allFinite(), "CadCurve::piece", "s", s(0), "a finite parameter");
  return static_cast<int>(piece_at(wrapped(s(0))));
}

ProfilePoint<2> CadCurve::evaluate(const Param<2>& s) const {
  require(s.allFinite(), "CadCurve::evaluate", "s", s(0), "a finite parameter");
  const double at = wrapped(s(0)), L = length();
  const std::size_t i = piece_at(at);
  const CadValue value = at < 0   ? beyond(pieces()[i].start(), at)
                         : at > L ? beyond(pieces()[i].end(), at - L)
                                  : pieces()[i].at(at - m_start[i]);
  const double speed = value.first.norm();
  const Vector<2> t = value.first / speed;
  ProfilePoint<2> point;
  point.x = value.x;
  point.x_s = value.first;
  point.x_ss[0] = value.second;
  point.n = m_side * left_of(t);
  point.n_s = m_side * left_of((value.second - t.dot(value.second) * t) / speed);
  return point;
}

ClosestPoint<2> CadCurve::closest_point(const Vector<2>& x, const Param<2>& near) const {
  require(x.allFinite(), "CadCurve::closest_point", "x", x.transpose(), "finite components");
  require(near.allFinite(), "CadCurve::closest_point", "near", near(0), "a finite parameter");
  const double L = length(), tolerance = 1e-12 * L;
  FootChoice choice(near(0), closed() ? L : 0, tolerance);
  const CadFoot foot = m_search.closest(pieces(), m_start, x, choice);
  const double s = choice.parameter();
  const CadValue at = pieces()[foot.piece].at(foot.s);
  const Vector<2> t = at.first.normalized(), rest = x - at.x;
  const double along = t.dot(rest), offset = m_side * left_of(t).dot(rest);
  const bool beyond = !closed() && ((s == 0 && along < -tolerance) || (s == L && along > tolerance));
  if (beyond) return {Param<2>(s), rest.norm(), true};
  // a joint has no normal through x if its tangents differ a little
  return {Param<2>(s), foot.normal ? offset : std::copysign(rest.norm(), offset), false};
}

double CadCurve::length_scale() const { return closed() ? length() / (2 * M_PI) : length(); }

} // namespace burnish
