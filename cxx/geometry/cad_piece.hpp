#pragma once
// One CAD curve as a piece of a profile: its direction of travel and a parameter that takes its arc length.
#include "geometry/cad_spans.hpp"
#include <memory>
#include <string>

namespace burnish {

/// s runs from 0 to length in the direction of travel, linear in the CAD parameter u.
class CadPiece {
public:
  CadPiece(int tag, std::shared_ptr<const CadSpans> spans);
  int tag() const { return m_tag; }
  double length() const { return m_length; }
  void reverse() { m_reversed = !m_reversed; }
  /// x, x_s, x_ss; beyond the ends the polynomials go on.
  CadValue at(double s) const;
  /// The same at its start and end.
  CadValue start() const { return at(0); }
  CadValue end() const { return at(m_length); }
  /// Parameters of start, knots and end, ascending.
  std::vector<double> knots() const;

private:
  int m_tag;
  std::shared_ptr<const CadSpans> m_spans;
  double m_begin, m_rate, m_length; ///< m_rate = du/ds
  bool m_reversed = false;
};

/// "(x, y)" for messages, without the rounding of coordinates that should be zero. @param size of the curves there
std::string place_text(const Vector<2>& x, double size);

} // namespace burnish
