#pragma once
// One span of a spline by Bezier poles.
#include "base/types.hpp"
#include <array>
#include <vector>

namespace burnish {

/// x, x_u, x_uu of a curve in space in its own parameter [length of the file, length/u, length/u^2].
struct CurveValue {
  Vector<3> x, first, second;
};

/// The span and both its derivatives have poles of their own, evaluated by de Casteljau's triangle: right to rounding
/// at any degree. (OpenCASCADE has points so, but derivatives by Boehm's algorithm or a power basis: relative errors
/// of 1e-14 at degree 9, 1e-12 at 12, 1e-7 at 21.)
class BezierSpan {
public:
  /// @param poles   of the whole spline, and their weights
  /// @param knots   each as often as it is repeated: degree + 1 more than poles
  /// @param at      the span from knots[at] to knots[at + 1], not empty
  /// @param shift   added to the parameters of the spline
  BezierSpan(const std::vector<Vector<3>>& poles, const std::vector<double>& weights,
             const std::vector<double>& knots, std::size_t at, double shift);
  /// The polynomials (or quotients of them) go on beyond the span.
  CurveValue at(double u) const;

private:
  using Poles = std::vector<Eigen::Vector4d>; ///< (w (x - origin), w)
  double m_begin, m_width;
  Vector<3> m_origin;
  std::array<Poles, 3> m_poles; ///< of the span, its first and second derivative
  bool m_rational;
};

} // namespace burnish
