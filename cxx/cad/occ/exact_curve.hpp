#pragma once
// A CAD curve in its own parameter: value and both derivatives, exact to rounding.
#include "geometry/bezier_span.hpp"
#include <memory>
#include <string>
#include <vector>

namespace burnish {

struct CadEdge;

/// Lines, conics, Bezier curves, B-splines, rational or not, and curves at a distance from these, from their axes
/// and poles.
class ExactCurve {
public:
  /// @param name  for messages
  /// @throws std::invalid_argument: no curve, no finite range of its parameter
  ExactCurve(const CadEdge& edge, const std::string& name);
  /// Beyond the ends the first and last span go on. At a knot: that of the span that begins there; `before`: of
  /// the one that ends there.
  CurveValue evaluate(double u, bool before = false) const;
  /// begin, knots, end; ascending. Between them the curve has all derivatives.
  const std::vector<double>& knots() const { return m_knots; }

private:
  struct Kept;
  std::shared_ptr<const Kept> m_kept;
  std::vector<double> m_knots;
};

} // namespace burnish
