#pragma once
// How fast an iteration with a kept factor converges, and whether a new factor pays (ALGORITHMS.md 5.2).
#include <vector>

namespace burnish {

class ConvergenceRate {
public:
  /// @param window iterations that the rate is measured over, >= 1; 0: never slow
  /// @param bound  iterations that may be left at that rate
  ConvergenceRate(int window = 0, double bound = 0) : m_window(window), m_bound(bound) {}
  /// A new factor: the rate is that of the iterations to come.
  void clear() { m_residuals.clear(); }
  /// Notes the residual of an iterate. @returns whether at the present rate more than `bound` iterations are left down to
  /// `allowed`; false until `window` iterations have been made. Only ratios count.
  bool slow(double residual, double allowed);
  /// Last residual over the first one of the factor; 1 without any.
  double fall() const { return m_residuals.empty() ? 1 : m_residuals.back() / m_residuals.front(); }

private:
  int m_window;
  double m_bound;
  std::vector<double> m_residuals;
};

} // namespace burnish
