#pragma once
// Anderson mixing in the energy product of the tangent (ALGORITHMS.md 5.5).
#include <Eigen/Dense>
#include <deque>

namespace burnish {

/// Fixed-point acceleration of z := z + g(z), where g = K^-1 b, so that g_i . K g_j = g_i . b_j costs
/// nothing.
class AndersonMixer {
public:
  explicit AndersonMixer(int memory) : m_memory(memory) {}
  void clear(); ///< gives the memory back, too
  /// Coefficients and mixed update: returns the increment to add to z instead of g.
  /// @param z iterate, n; @param g correction, n; @param b right-hand side with K g = b, n (its first entries
  /// may be
  ///          shorter than z: the product runs over b.size() entries)
  /// Skipped (returns g) without history or when a coefficient exceeds 5.
  Eigen::VectorXd mix(const Eigen::VectorXd& z, const Eigen::VectorXd& g, const Eigen::VectorXd& b);
  bool mixed() const { return m_mixed; } ///< whether the last call changed g

private:
  struct Entry {
    Eigen::VectorXd z, g, b;
  };
  struct Difference { // of two iterations that follow each other
    Eigen::VectorXd z_and_g, g, b;
  };
  void add_difference(Entry before, const Entry& now);
  int m_memory;
  bool m_mixed = false;
  bool m_has_last = false;
  Entry m_last;
  std::deque<Difference> m_differences;
  Eigen::MatrixXd m_products; // g_i . b_j of the differences
};

} // namespace burnish
