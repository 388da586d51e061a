#pragma once
// A CAD curve in its own parameter: value and both derivatives, exact to rounding.
#include "base/types.hpp"
#include <memory>
#include <string>
#include <vector>

namespace burnish {

struct CadEdge;

/// Lines, conics, Bezier curves, B-splines, rational or not, and curves at a distance from these, evaluated by
/// OpenCASCADE from their poles and axes. (By its curves, not its adaptors: those keep a power basis, which is
/// wrong by 1e-8 at degree 21, and is changed by asking.)
class ExactCurve {
public:
  /// x, x_u, x_uu [length of the file, length/u, length/u^2].
  struct Value {
    Vector<3> x, first, second;
  };
  /// @param name  for messages
  /// @throws std::invalid_argument: no curve, no finite range of its parameter
  ExactCurve(const CadEdge& edge, const std::string& name);
  /// Beyond the ends the first and last span go on. At a knot: that of the span that begins there; `before`: of
  /// the one that ends there.
  Value evaluate(double u, bool before = false) const;
  /// begin, knots, end; ascending. Between them the curve has all derivatives.
  const std::vector<double>& knots() const { return m_knots; }

private:
  struct Kept;
  std::shared_ptr<const Kept> m_kept;
  std::vector<double> m_knots;
};

} // namespace burnish
