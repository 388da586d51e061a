#pragma once
// Circle about the origin of the tool's frame: a roller, or (inside) a hollow die.
#include "geometry/shape_kind.hpp"

namespace burnish {

/// Periodic profile x(s) = R e(s), parameter s = angle [rad], any real number (METHOD.md 2.3).
/// The point runs counter-clockwise in both variants; only the side of the body differs:
///   outside (default)  n = +e(s), gap = |x| - R
///   inside             n = -e(s), gap = R - |x|   (body in the hollow, normal to the center)
class Circle : public Profile<2> {
public:
  /// @param radius  R > 0 [length]
  /// @param inside  true: the body is inside the circle
  /// @throws std::invalid_argument if radius is not positive and finite
  explicit Circle(double radius, bool inside = false);
  double radius() const { return m_radius; }
  bool inside() const { return m_inside; }

  /// x = R e, x_s = R t, x_ss = -R e, n = +-e, n_s = +-t with t = e'(s); derivatives per radian.
  /// @throws std::invalid_argument if s is not finite
  ProfilePoint<2> evaluate(const Param<2>& s) const override;

  /// Foot point s = angle of x + 2 pi k, with k such that s is nearest to `near` (|s - near| <= pi); exact
  /// up to the rounding of near. At the center every point of the circle is equally near: s = near is
  /// returned. on_end is always false.
  /// @param x     point in the tool's frame, 2 [length]
  /// @param near  parameter to stay close to [rad]
  /// @return s [rad]; gap [length], outside: >= -R, inside: <= R
  /// @throws std::invalid_argument if x or near is not finite
  ClosestPoint<2> closest_point(const Vector<2>& x, const Param<2>& near) const override;

  /// The radius [length].
  double length_scale() const override { return m_radius; }
  /// 0 <= s < 2 pi, closed.
  ParamRange<2> range() const override;
  double tightest_radius() const override { return m_radius; }

private:
  double m_radius;
  bool m_inside;
};

/// "circle=R" in scripts.
ShapeKind circle_shape();

} // namespace burnish
