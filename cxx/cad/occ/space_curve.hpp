#pragma once
// An edge of a CAD body as a curve of space, divided into parts with bounds.
#include "base/types.hpp"
#include "cad/occ/exact_curve.hpp"
#include <Eigen/Geometry>

namespace burnish {

/// Lengths in the unit of the file.
class SpaceCurve {
public:
  struct Nearest {
    double u = 0; ///< the curve's parameter
    Vector<3> x{0, 0, 0};
    double distance = 0;
  };
  explicit SpaceCurve(ExactCurve curve);
  int parts() const { return static_cast<int>(m_u.size()) - 1; }
  /// About a part, with what it bows out.
  Eigen::AlignedBox3d box(int part) const;
  Vector<3> start_of(int part) const { return at(m_u[static_cast<std::size_t>(part)]).x; }
  Nearest nearest(int part, const Vector<3>& p) const;
  double begin() const { return m_u.front(); }
  double end() const { return m_u.back(); }
  /// Ends of the parts, ascending: at the fraction f (0..1) of their number.
  double parameter(double f) const;
  CurveValue at(double u) const { return m_curve.evaluate(u); }
  double length() const; ///< of its chords [length]

private:
  void add(double begin, double end, int depth);
  ExactCurve m_curve;
  std::vector<double> m_u;
  std::vector<double> m_sag; ///< of each part: it stays this close to its chord
};

} // namespace burnish
