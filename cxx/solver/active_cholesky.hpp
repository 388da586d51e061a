#pragma once
// Cholesky factor of a part of a dense symmetric positive definite matrix; the part changes by a few rows at a time.
#include <Eigen/Dense>
#include <memory>
#include <vector>

namespace burnish {

/// Keeps the factor L L' of C over the selected indices. A selection that was made before costs nothing; one that
/// differs by few indices takes them out of the factor and appends them to it; else the part is factorized anew.
class ActiveCholesky {
public:
  /// @param updates_from  size of the part from which on the factor is updated; below, a new one is as cheap
  explicit ActiveCholesky(int updates_from = 400) : m_updates_from(updates_from) {}
  /// A matrix, symmetric; the factor made before is forgotten.
  void set(std::shared_ptr<const Eigen::MatrixXd> matrix);
  const Eigen::MatrixXd& matrix() const { return *m_matrix; }
  /// Makes the part over these indices (each once) current.
  /// @returns false if it is not positive definite; then there is no factor
  bool select(const std::vector<int>& indices);
  /// C_aa^-1 B for the current part. @param B rows in the order of the last selection
  Eigen::MatrixXd solve(const Eigen::MatrixXd& B) const;
  long factorizations() const { return m_factorizations; }
  long updates() const { return m_updates; } ///< rows taken out or appended

private:
  bool factorize();
  bool append(int index);
  void remove(Eigen::Index position);
  bool update(const std::vector<int>& indices);

  int m_updates_from;
  std::shared_ptr<const Eigen::MatrixXd> m_matrix;
  Eigen::MatrixXd m_lower;           // the leading m_order.size() rows count
  std::vector<int> m_order;          // indices in the order of the factor
  std::vector<int> m_selected;       // as asked for
  std::vector<Eigen::Index> m_place; // per selected index: its row in the factor
  long m_factorizations = 0, m_updates = 0;
};

} // namespace burnish
