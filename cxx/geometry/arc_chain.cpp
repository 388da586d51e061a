#include "geometry/arc_chain.hpp"
#include "base/error.hpp"
#include "geometry/foot_choice.hpp"
#include "geometry/plane.hpp"
#include <algorithm>

namespace burnish {

namespace {

// Positive if the chain runs counter-clockwise: sum of its turns is +2 pi or -2 pi, the lines add nothing.
double turning(const std::vector<ArcPiece>& pieces) {
  double sum = 0;
  for (const ArcPiece& piece : pieces) sum += piece.curvature * piece.length;
  return sum;
}

} // namespace

ArcChain::ArcChain(const std::vector<Vector<2>>& points, const std::vector<double>& radii, bool closed,
                   bool inside)
    : m_pieces(filleted(points, radii, closed)), m_start{0}, m_closed(closed) {
  for (const ArcPiece& piece : m_pieces) m_start.push_back(m_start.back() + piece.length);
  m_side = closed && turning(m_pieces) > 0 ? -1 : 1;
  if (inside) m_side = -m_side;
}

double ArcChain::wrapped(double s) const { return m_closed ? s - length() * std::floor(s / length()) : s; }

int ArcChain::piece_at(double wrapped_s) const {
  const auto next = std::upper_bound(m_start.begin(), m_start.end(), wrapped_s);
  const auto count = static_cast<std::ptrdiff_t>(m_pieces.size());
  return static_cast<int>(std::clamp<std::ptrdiff_t>(next - m_start.begin() - 1, 0, count - 1));
}

int ArcChain::piece(const Param<2>& s) const {
  require(s.allFinite(), "ArcChain::piece", "s", s(0), "a finite arc length");
  return piece_at(wrapped(s(0)));
}

ProfilePoint<2> ArcChain::evaluate(const Param<2>& s) const {
  require(s.allFinite(), "ArcChain::evaluate", "s", s(0), "a finite arc length");
  const double at = wrapped(s(0));
  const auto i = static_cast<std::size_t>(piece_at(at));
  const ArcPiece& piece = m_pieces[i];
  const double local = at - m_start[i];
  const Vector<2> t = piece.direction(local), left = left_of(t);
  ProfilePoint<2> point;
  point.x = piece.point(local);
  point.x_s = t;
  point.x_ss[0] = piece.curvature * left;
  point.n = m_side * left;
  point.n_s = -m_side * piece.curvature * t;
  return point;
}

ClosestPoint<2> ArcChain::closest_point(const Vector<2>& x, const Param<2>& near) const {
  require(x.allFinite(), "ArcChain::closest_point", "x", x.transpose(), "finite components");
  require(near.allFinite(), "ArcChain::closest_point", "near", near(0), "a finite arc length");
  const double L = length(), tolerance = 1e-12 * L, here = wrapped(near(0));
  FootChoice choice(near(0), m_closed ? L : 0, tolerance);
  ArcFoot best{};
  for (std::size_t i = 0; i < m_pieces.size(); ++i) {
    const double start = m_start[i], end = m_start[i + 1];
    const ArcFoot foot = m_pieces[i].closest(x, std::clamp(here, start, end) - start);
    if (choice.offer(std::min(start + foot.s, end), foot.distance, foot.excess <= tolerance)) best = foot;
  }
  const double s = choice.parameter();
  const bool beyond = !m_closed && (s == 0 || s == L) && best.excess > tolerance;
  return {Param<2>(s), beyond ? best.distance : m_side * best.offset, beyond};
}

double ArcChain::length_scale() const { return m_closed ? length() / (2 * M_PI) : length(); }

double ArcChain::tightest_radius() const {
  double sharpest = 0;
  for (const ArcPiece& piece : m_pieces) sharpest = std::max(sharpest, std::abs(piece.curvature));
  return 1 / sharpest;
}

ShapeKind arc_chain_shape() {
  return {"chain=[x0,y0,r0, x1,y1,r1, ...]",
          {{"chain", ArgumentKind::NUMBERS,
            "lines from corner to corner, each corner with the radius of its fillet [length]"},
           {"closed", ArgumentKind::FLAG,
            "true: back to the first corner, body outside; else the body is on the left"},
           {"inside", ArgumentKind::FLAG, "true: body on the other side"}},
          [](const Arguments& given) {
            const std::vector<double> p = given.list("chain");
            require(p.size() % 3 == 0 && !p.empty(), "chain", "number of values in chain", p.size(),
                    "three per point: [x0,y0,r0, x1,y1,r1, ...]");
            std::vector<Vector<2>> points;
            std::vector<double> radii;
            for (std::size_t i = 0; i < p.size(); i += 3) {
              points.emplace_back(p[i], p[i + 1]);
              radii.push_back(p[i + 2]);
            }
            return std::make_shared<ArcChain>(points, radii, given.flag("closed"), given.flag("inside"));
          }};
}

} // namespace burnish
