#include "geometry/segment.hpp"
#include "base/error.hpp"
#include "geometry/plane.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {

Segment::Segment(const Vector<2>& a, const Vector<2>& b) : m_a(a), m_b(b) {
  require(a.allFinite(), "Segment", "a", a.transpose(), "finite components");
  require(b.allFinite(), "Segment", "b", b.transpose(), "finite components");
  m_length = (b - a).norm();
  require(std::isfinite(m_length) && m_length > 0, "Segment", "length |b - a|", m_length,
          "a finite number > 0 (two different ends)");
  m_tangent = (b - a) / m_length;
  m_normal = left_of(m_tangent);
}

ProfilePoint<2> Segment::evaluate(const Param<2>& s) const {
  require(s.allFinite(), "Segment::evaluate", "s", s(0), "a finite arc length");
  ProfilePoint<2> point;
  point.x = m_a + s(0) * m_tangent;
  point.x_s = m_tangent;
  point.x_ss[0].setZero();
  point.n = m_normal;
  point.n_s.setZero();
  return point;
}

ClosestPoint<2> Segment::closest_point(const Vector<2>& x, const Param<2>&) const {
  require(x.allFinite(), "Segment::closest_point", "x", x.transpose(), "finite components");
  const double projection = m_tangent.dot(x - m_a);
  const double s = std::clamp(projection, 0.0, m_length);
  const bool on_end = std::abs(projection - s) > 1e-12 * m_length;
  const double gap = on_end ? (x - (m_a + s * m_tangent)).norm() : m_normal.dot(x - m_a);
  return {Param<2>(s), gap, on_end};
}

ShapeKind segment_shape() {
  return {"line=[x0,y0,x1,y1]",
          {{"line", ArgumentKind::NUMBERS,
            "straight from the first end to the second, body on the left [length]"}},
          [](const Arguments& given) {
            const std::vector<double> p = given.list("line");
            require(p.size() == 4, "line", "number of values in line", p.size(), "4: [x0,y0,x1,y1]");
            return std::make_shared<Segment>(Vector<2>(p[0], p[1]), Vector<2>(p[2], p[3]));
          },
          "; swap the ends of a line to turn it"};
}

} // namespace burnish
