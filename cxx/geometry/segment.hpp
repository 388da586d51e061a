#pragma once
// Straight line between two points of the tool's frame: a flat punch, a die wall, a plate.
#include "geometry/shape_kind.hpp"
#include <limits>

namespace burnish {

/// Profile x(s) = a + s t, parameter s = arc length from a, 0 <= s <= L = |b - a|, t = (b - a)/L.
/// The normal is to the LEFT of a -> b (body on the left, tool on the right); swap a and b to turn it.
class Segment : public Profile<2> {
public:
  /// @param a, b  ends in the tool's frame, 2 [length]
  /// @throws std::invalid_argument if a or b is not finite or a == b
  Segment(const Vector<2>& a, const Vector<2>& b);
  const Vector<2>& a() const { return m_a; }
  const Vector<2>& b() const { return m_b; }
  double length() const { return m_length; }

  /// x = a + s t, x_s = t, n = t turned by +90 degrees, x_ss = n_s = 0. Beyond the ends the line goes on.
  /// @param s  arc length from a [length], any finite number
  /// @throws std::invalid_argument if s is not finite
  ProfilePoint<2> evaluate(const Param<2>& s) const override;

  /// Foot point, clamped to the ends; `near` is not used.
  ///   0 <= t.(x-a) <= L:  gap = n.(x-a), negative on the right (penetration), on_end = false
  ///   beyond an end:      gap = +distance to that end on either side of the line, on_end = true
  /// A segment closes no area, so a point beyond its ends is never inside the tool. Hence the gap is
  /// continuous on the left, and behind the tool it jumps from -d to +d across the normals at the ends; an
  /// excess of 1e-12 L over an end still counts as the end itself (a node brought to the end by an event
  /// stays in contact).
  /// @param x  point in the tool's frame, 2 [length]
  /// @return s in [0, L]; gap [length]
  /// @throws std::invalid_argument if x is not finite
  ClosestPoint<2> closest_point(const Vector<2>& x, const Param<2>& near) const override;

  /// The length L [length].
  double length_scale() const override { return m_length; }
  /// 0 <= s <= L, open.
  ParamRange<2> range() const override { return {Param<2>(0.), Param<2>(m_length), false}; }
  double tightest_radius() const override { return std::numeric_limits<double>::infinity(); }

private:
  Vector<2> m_a, m_b, m_tangent, m_normal;
  double m_length;
};

/// "line=[x0,y0,x1,y1]" in scripts.
ShapeKind segment_shape();

} // namespace burnish
