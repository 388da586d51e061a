#include "geometry/circle.hpp"
#include "base/error.hpp"
#include "geometry/plane.hpp"
#include <cmath>

namespace burnish {

Circle::Circle(double radius, bool inside) : m_radius(radius), m_inside(inside) {
  require(std::isfinite(radius) && radius > 0, "Circle", "radius", radius, "a finite number > 0");
}

ProfilePoint<2> Circle::evaluate(const Param<2>& s) const {
  require(s.allFinite(), "Circle::evaluate", "s", s(0), "a finite angle");
  const Vector<2> e = plane_direction(s(0));
  const Vector<2> t = left_of(e);
  const double side = m_inside ? -1.0 : 1.0;
  ProfilePoint<2> point;
  point.x = m_radius * e;
  point.x_s = m_radius * t;
  point.x_ss[0] = -m_radius * e;
  point.n = side * e;
  point.n_s = side * t;
  return point;
}

ClosestPoint<2> Circle::closest_point(const Vector<2>& x, const Param<2>& near) const {
  require(x.allFinite(), "Circle::closest_point", "x", x.transpose(), "finite components");
  require(near.allFinite(), "Circle::closest_point", "near", near(0), "a finite angle");
  const double turn = 2 * M_PI;
  const double distance = x.norm();
  // the center has no direction: stay where the node was
  const double angle = distance > 0 ? std::atan2(x.y(), x.x()) : near(0);
  const double s = angle + turn * std::round((near(0) - angle) / turn);
  const double gap = m_inside ? m_radius - distance : distance - m_radius;
  return {Param<2>(s), gap, false};
}

ParamRange<2> Circle::range() const { return {Param<2>(0.), Param<2>(2 * std::acos(-1.)), true}; }

ShapeKind circle_shape() {
  return {"circle=R",
          {{"circle", ArgumentKind::NUMBER, "roller about the origin of the tool's frame; radius [length]"},
           {"inside", ArgumentKind::FLAG, "true: a hollow die, the body inside the circle"}},
          [](const Arguments& given) {
            return std::make_shared<Circle>(given.number("circle", 0), given.flag("inside"));
          }};
}

} // namespace burnish
