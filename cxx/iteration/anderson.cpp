#include "iteration/anderson.hpp"
#include <utility>

namespace burnish {

void AndersonMixer::clear() {
  m_has_last = false;
  m_last = Entry();
  m_differences.clear();
  m_products.resize(0, 0);
}

// The oldest one is dropped beyond the memory. In the place of `before`: no further vectors.
void AndersonMixer::add_difference(Entry before, const Entry& now) {
  const Eigen::Index n = now.b.size();
  if (static_cast<int>(m_differences.size()) == m_memory) {
    m_differences.pop_front();
    m_products = m_products.bottomRightCorner(m_memory - 1, m_memory - 1).eval();
  }
  before.g = now.g - before.g;
  before.z = (now.z - before.z) + before.g;
  before.b = now.b - before.b;
  before.g.conservativeResize(n);
  m_differences.push_back({std::move(before.z), std::move(before.g), std::move(before.b)});
  const Eigen::Index m = static_cast<Eigen::Index>(m_differences.size());
  m_products.conservativeResize(m, m);
  for (Eigen::Index i = 0; i < m; ++i) {
    m_products(i, m - 1) = m_differences[i].g.dot(m_differences.back().b);
    m_products(m - 1, i) = m_differences.back().g.dot(m_differences[i].b);
  }
}

Eigen::VectorXd AndersonMixer::mix(const Eigen::VectorXd& z, const Eigen::VectorXd& g,
                                   const Eigen::VectorXd& b) {
  m_mixed = false;
  if (m_memory == 0) return g;
  Entry now{z, g, b};
  if (m_has_last) add_difference(std::move(m_last), now);
  m_last = std::move(now);
  m_has_last = true;
  const Eigen::Index m = static_cast<Eigen::Index>(m_differences.size()), n = b.size();
  if (m < 1) return g;
  Eigen::MatrixXd normal = 0.5 * (m_products + m_products.transpose());
  normal.diagonal() *= 1 + 1e-12;
  Eigen::VectorXd right(m);
  for (Eigen::Index i = 0; i < m; ++i) right[i] = m_differences[i].b.dot(g.head(n));
  const Eigen::VectorXd c = normal.ldlt().solve(right);
  if (!c.allFinite() || c.cwiseAbs().maxCoeff() > 5) return g;
  Eigen::VectorXd step = g;
  for (Eigen::Index i = 0; i < m; ++i) step -= c[i] * m_differences[i].z_and_g;
  m_mixed = true;
  return step;
}

} // namespace burnish
