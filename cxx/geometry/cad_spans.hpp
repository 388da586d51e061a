#pragma once
// A plane CAD curve as polynomials between its knots: value and both derivatives by u to rounding.
#include "geometry/cad_knots.hpp"
#include <string>

namespace burnish {

/// Where a curve comes from: columns are points (derivatives) at the parameters u.
struct CadSource {
  std::string name; ///< for messages
  double begin = 0, end = 0;
  CadSamples value;
  CadSamples derivative; ///< exact to rounding; none if only values are
};

/// x, x_u, x_uu of a curve in its own parameter u [length, length/u, length/u^2].
struct CadValue {
  Vector<2> x, first, second;
};

/// gmsh 4.8.4 gives no usable second derivative: it is a central difference of the first one with a step of
/// 1e-3 in u (error 2e-7 on a circle, 2e-4 on a spline), and with the built-in kernel the first one is a
/// difference, too (error 1e-8; of Bezier curves plainly wrong). Curves of CAD systems are polynomials,
/// rational functions or arcs between their knots, so they are recovered here: Chebyshev polynomials that
/// agree with values (and OpenCASCADE's exact first derivatives) to 2e-13 between the knots; their
/// derivatives are then right to 1e-10 and better. OpenCASCADE evaluates Bezier curves of high degree with
/// more rounding: up to 2e-11 is let pass, second derivatives are then right to 1e-8. What cannot be
/// recovered is refused.
class CadSpans {
public:
  /// @throws std::invalid_argument if the curve has no such form
  explicit CadSpans(const CadSource& source);
  /// Beyond the ends the first and last polynomials go on. At a knot: that of the span that begins there;
  /// `before`: of the one that ends there.
  CadValue evaluate(double u, bool before = false) const;
  /// begin, knots, end; ascending.
  const std::vector<double>& knots() const { return m_knots; }

private:
  struct Span {
    double begin, end;
    Coefficients x, first, second; ///< on [begin, end]
  };
  bool recover(const CadSource& source, double speed, double& jump);
  [[noreturn]] void refuse(const CadSource& source, double jump) const;
  std::vector<double> knots_of_value(const CadSource& source) const;
  bool fit(const CadSource& source, double begin, double end, Span& span) const;
  bool cover(const CadSource& source, double begin, double end, int depth);

  double m_size = 0, m_noise = 0; ///< largest |x|; rounding of x_u
  double m_rounding;              ///< relative
  std::vector<Span> m_spans;
  std::vector<double> m_knots;
};

} // namespace burnish
