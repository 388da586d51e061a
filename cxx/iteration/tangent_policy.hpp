#pragma once
// When an iteration takes a new tangent, and how much of elastic moduli it has (ALGORITHMS.md 5.2, 5.8).
#include "iteration/convergence_rate.hpp"

namespace burnish {

class TangentPolicy {
public:
  /// A step begins.
  void begin();
  /// The tangent of every iteration is new: a matrix of the caller's.
  void set_condensed(bool condensed) { m_condensed = condensed; }
  bool condensed() const { return m_condensed; }
  /// Looks at the residual of an iterate that has not converged [force].
  void look(double residual, double allowed);
  bool grows() const { return m_grows; }     ///< it is much larger than that of the last iterate
  bool has_grown() const { return m_grown; } ///< it has been so in this step
  bool lags() const { return m_lags; }       ///< the rate of convergence asks for too many iterations more
  /// The iteration goes on from it.
  void go_on(double residual);
  double last() const { return m_last; } ///< residual that it went on from last [force], < 0: none
  /// A tangent was factored, or was not positive definite.
  void factored(bool definite);
  /// Part of elastic moduli to mix into the next tangent: none, but after losses of definiteness, and where condensed iterations
  /// are slow (cycles of plastic points).
  double elastic_blend() const;
  /// The tangent stays indefinite: a limit load.
  bool blend_exhausted() const { return m_indefinite > MAX_INDEFINITE; }
  /// No elastic moduli will help any more.
  bool desperate() const { return m_indefinite >= MAX_INDEFINITE; }
  static constexpr int MAX_INDEFINITE = 3; ///< tangents in a row that may be indefinite

private:
  ConvergenceRate m_rate;
  bool m_condensed = false, m_grows = false, m_grown = false, m_lags = false;
  double m_last = -1;
  int m_slow = 0, m_indefinite = 0; // m_slow: condensed iterations that were slow
  int m_falls = 0;                  // condensed iterations in a row that made the residual smaller
};

} // namespace burnish
