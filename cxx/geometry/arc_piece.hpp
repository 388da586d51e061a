#pragma once
// One straight line or circular arc of a chain, in one formula for both.
#include "base/types.hpp"
#include <vector>

namespace burnish {

/// Nearest point of a piece. Beyond an end: that end, excess > 0.
struct ArcFoot {
  double s;        ///< arc length from the start of the piece, 0 <= s <= length [length]
  double excess;   ///< by how much the projection lies beyond the piece, along it; <= 0 inside [length]
  double distance; ///< from the foot point [length]
  double offset;   ///< along the left normal, positive left; at an end: part along its normal [length]
};

/// x(s) = start + sin(k s)/k t + (1 - cos(k s))/k n, arc length s, n = left normal of t at the start.
struct ArcPiece {
  Vector<2> start;   ///< [length]
  Vector<2> tangent; ///< unit, direction of travel at the start
  double curvature;  ///< k, positive if the piece turns left, 0 for a line [1/length]
  double length;     ///< > 0; |k| length < pi

  /// Point, unit tangent at arc length s; both go on smoothly beyond the ends.
  Vector<2> point(double s) const;
  Vector<2> direction(double s) const;
  /// @param x     point, 2 [length]
  /// @param near  taken where every point of the arc is equally near: x at its center
  ArcFoot closest(const Vector<2>& x, double near) const;
};

/// Points common to two pieces: crossings, and ends of one that lie on the other (within tolerance [length]).
std::vector<Vector<2>> common_points(const ArcPiece& a, const ArcPiece& b, double tolerance);

} // namespace burnish
