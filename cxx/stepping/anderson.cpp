#include "stepping/anderson.hpp"

namespace burnish {

Eigen::VectorXd AndersonMixer::mix(const Eigen::VectorXd& z, const Eigen::VectorXd& g,
                                   const Eigen::VectorXd& b) {
  m_mixed = false;
  m_history.push_back({z, g, b});
  if (static_cast<int>(m_history.size()) > m_memory + 1) m_history.pop_front();
  const Eigen::Index m = static_cast<Eigen::Index>(m_history.size()) - 1, n = b.size();
  if (m < 1 || m_memory == 0) return g;
  Eigen::MatrixXd dg(n, m), db(n, m);
  for (Eigen::Index i = 0; i < m; ++i) {
    dg.col(i) = (m_history[i + 1].g - m_history[i].g).head(n);
    db.col(i) = m_history[i + 1].b - m_history[i].b;
  }
  Eigen::MatrixXd normal = dg.transpose() * db;
  normal = 0.5 * (normal + normal.transpose()).eval();
  const Eigen::VectorXd right = db.transpose() * g.head(n);
  normal.diagonal() *= 1 + 1e-12;
  const Eigen::VectorXd c = normal.ldlt().solve(right);
  if (!c.allFinite() || c.cwiseAbs().maxCoeff() > 5) return g;
  Eigen::VectorXd step = g;
  for (Eigen::Index i = 0; i < m; ++i) {
    const Entry &old = m_history[i], &now = m_history[i + 1];
    step -= c[i] * ((now.z - old.z) + (now.g - old.g));
  }
  m_mixed = true;
  return step;
}

} // namespace burnish
