#pragma once
// One CAD curve as a piece of a profile: its direction of travel and a parameter that takes its arc length.
#include "cad/occ/exact_curve.hpp"

namespace burnish {

/// x, x_s, x_ss in the plane.
struct CadValue {
  Vector<2> x, first, second;
};

/// s runs from 0 to length in the direction of travel, linear in the CAD parameter u.
class CadPiece {
public:
  /// @param curve  in the plane z = 0
  /// @param scale  tool's unit of length per unit of the curve
  CadPiece(int tag, ExactCurve curve, double scale);
  int tag() const { return m_tag; }
  double length() const { return m_length; }
  void reverse() { m_reversed = !m_reversed; }
  /// Beyond the ends the curve goes on.
  CadValue at(double s) const;
  /// The same at its start and end.
  CadValue start() const { return at(0); }
  CadValue end() const { return at(m_length); }
  /// The parameter u of the file at s.
  double parameter(double s) const { return m_begin + m_rate * (m_reversed ? m_length - s : s); }
  /// Parameters of start, knots and end, ascending.
  std::vector<double> knots() const;

private:
  int m_tag;
  ExactCurve m_curve;
  double m_scale, m_begin, m_rate, m_length; ///< m_rate = du/ds
  bool m_reversed = false;
};

/// "(x, y)" for messages, without the rounding of coordinates that should be zero. @param size of the curves there
std::string place_text(const Vector<2>& x, double size);

} // namespace burnish
