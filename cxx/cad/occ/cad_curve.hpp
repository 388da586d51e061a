#pragma once
// Profiles drawn in a CAD system: .geo, .step, .stp or .brep files.
#include "cad/cad_selection.hpp"
#include "cad/occ/cad_search.hpp"
#include "geometry/profile.hpp"

namespace burnish {

/// Curves of the plane z = 0, ordered into one open chain or closed loop and turned as needed; neighbors must
/// join smoothly. Parameter s: on each curve linear in the CAD parameter, as long as its arc; so |x_s| = 1 on
/// average, and exactly on lines and circles.
///   open    0 <= s <= L, the body on the LEFT of the direction of the FIRST curve given (else: lowest tag)
///   closed  periodic, s any real number, the body OUTSIDE; s = 0 where the first curve begins
///   inside  swaps the side of the body in both
/// All values come from the exact curve (ExactCurve), no facets.
/// OpenCASCADE converts STEP files to mm by itself, whatever their unit: scale=1e-3 makes meters of them;
/// .geo and .brep files keep their numbers. OpenCASCADE takes points closer than 1e-7 of its unit for one:
/// draw small parts in mm.
class CadCurve : public Profile<2> {
public:
  /// @throws std::invalid_argument: see CadFile, ExactCurve, chained; a scale that is not positive, an unknown
  /// tag (lists those that exist; tells if it is a surface), a curve that is not in the plane z = 0, without
  /// length, with points that are not finite or beyond 1e50, with a corner (more than 1e-3 rad) or a sudden
  /// change of speed inside; a chain that crosses or touches itself
  explicit CadCurve(const CadSelection& selection);
  /// The same of curves at hand. @param inside swaps the side of the body
  CadCurve(const std::vector<CadPiece>& curves, bool inside);
  const std::vector<CadPiece>& pieces() const { return m_chain.pieces; }
  double length() const { return m_start.back(); }
  bool closed() const { return m_chain.closed; }

  /// Beyond the ends of an open chain its circle of curvature there goes on at the speed of the end.
  /// @throws std::invalid_argument if s is not finite
  ProfilePoint<2> evaluate(const Param<2>& s) const override;

  /// Nearest of all points of the chain, to rounding (close to a center of curvature: to 1e-8 of the
  /// distance). gap = distance along the normal at the foot point, negative in the tool. Open chains, beyond
  /// an end: as Segment, gap = +distance to that end, on_end; an excess of 1e-12 L over an end still counts
  /// as the end itself. Where several points are equally near (1e-12 L): the one nearest to `near`.
  /// @param x     point in the tool's frame, 2 [length]
  /// @param near  parameter to stay close to; closed: picks the branch, |s - near| <= L/2 [length]
  /// @throws std::invalid_argument if x or near is not finite
  ClosestPoint<2> closest_point(const Vector<2>& x, const Param<2>& near) const override;

  /// Open: the length L; closed: L/(2 pi), the radius of the circle of that length [length].
  double length_scale() const override;
  ParamRange<2> range() const override { return {Param<2>(0.), Param<2>(length()), closed()}; }
  /// Smallest radius of curvature on either side; infinity for straight lines [length].
  double tightest_radius() const override { return m_tightest; }
  /// CAD curves counted from 0 in the order of travel.
  int piece(const Param<2>& s) const override;

private:
  double wrapped(double s) const;
  std::size_t piece_at(double wrapped_s) const;
  bool counterclockwise() const;
  double sharpest() const;

  CadChain m_chain;
  std::vector<double> m_start; ///< parameter where each curve starts; last entry: L
  CadSearch m_search;
  double m_side; ///< +1: body on the left
  double m_tightest;
};

/// The curves of a selection in the order given, in the tool's unit of length.
std::vector<CadPiece> read_curves(const CadSelection& selection);

} // namespace burnish
