#include "iteration/convergence_rate.hpp"
#include <cmath>

namespace burnish {

bool ConvergenceRate::slow(double residual, double allowed) {
  m_residuals.push_back(residual);
  const int last = static_cast<int>(m_residuals.size()) - 1;
  if (m_window <= 0 || last < m_window || residual <= allowed) return false;
  const double fall = std::log(m_residuals[last - m_window] / residual) / m_window; // per iteration
  return !(fall * m_bound >= std::log(residual / allowed));
}

} // namespace burnish
