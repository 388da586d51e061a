#pragma once
// Straight lines joined by fillet arcs: punches and dies with rounded edges, cams, crowned tools.
#include "geometry/arc_piece.hpp"
#include "geometry/shape_kind.hpp"

namespace burnish {

/// Lines from point to point, each corner replaced by the arc of the given radius that touches both its
/// lines. Parameter s = arc length from the first point (closed: from where the line after the first point's
/// fillet begins). The tangent is continuous, the curvature jumps at the joints (METHOD.md 2.5); passing from piece
/// to piece is an event (METHOD.md 4.2).
///   open    0 <= s <= L, the body on the LEFT of the direction of travel
///   closed  periodic, s any real number, the body OUTSIDE whatever the direction of travel
///   inside  swaps the side of the body in both
class ArcChain : public Profile<2> {
public:
  /// @param points  corners in the order of travel, each 2 [length]; a closed chain returns to the first one
  ///                by itself
  /// @param radii   fillet radius at each point [length]; open: 0 at both ends. A fillet may use up its
  ///                lines (a crowned punch: one arc). Without effect where the chain goes straight on.
  /// @param closed  joins the last point to the first
  /// @param inside  body on the other side
  /// @throws std::invalid_argument, with the place, for: fewer than 2 (closed: 3) points, not one radius per
  /// point, NaN, repeated points, negative radii, a corner (more than 1e-9 rad) without fillet (tells the
  /// angle and the largest radius that fits), a chain that turns back on itself, fillets that overlap, a
  /// chain that crosses or touches itself
  ArcChain(const std::vector<Vector<2>>& points, const std::vector<double>& radii, bool closed = false,
           bool inside = false);
  const std::vector<ArcPiece>& pieces() const { return m_pieces; }
  double length() const { return m_start.back(); }
  bool closed() const { return m_closed; }

  /// x_s = t (unit), x_ss = k left(t), n = +-left(t), n_s = -+k t; beyond the ends of an open chain its first
  /// and last piece go on.
  /// @param s  arc length [length]
  /// @throws std::invalid_argument if s is not finite
  ProfilePoint<2> evaluate(const Param<2>& s) const override;

  /// Nearest of all points of the chain. gap = distance along the normal at the foot point, negative in the
  /// tool. Open chains, beyond an end: as Segment, gap = +distance to that end, on_end = true; an excess of
  /// 1e-12 L over an end still counts as the end itself. Where several points are equally near (1e-12 L): the
  /// one nearest to `near`.
  /// @param x     point in the tool's frame, 2 [length]
  /// @param near  arc length to stay close to; closed: picks the branch, |s - near| <= L/2 [length]
  /// @throws std::invalid_argument if x or near is not finite
  ClosestPoint<2> closest_point(const Vector<2>& x, const Param<2>& near) const override;

  /// Open: the length L; closed: L/(2 pi), the radius of the circle of that length [length].
  double length_scale() const override;
  ParamRange<2> range() const override { return {Param<2>(0.), Param<2>(length()), m_closed}; }
  /// Smallest fillet radius; infinity without fillets [length].
  double tightest_radius() const override;
  /// Lines and arcs counted from 0; beyond the ends of an open chain the first and the last one.
  int piece(const Param<2>& s) const override;

private:
  double wrapped(double s) const;
  int piece_at(double wrapped_s) const;

  std::vector<ArcPiece> m_pieces;
  std::vector<double> m_start; ///< arc length where each piece starts; last entry: L
  bool m_closed;
  double m_side; ///< +1: body on the left
};

/// Lines and arcs of a chain, checked as ArcChain says, in the order of travel; without lines of zero length.
std::vector<ArcPiece> filleted(const std::vector<Vector<2>>& points, const std::vector<double>& radii,
                               bool closed);

/// "chain=[x0,y0,r0, x1,y1,r1, ...]" in scripts.
ShapeKind arc_chain_shape();

} // namespace burnish
