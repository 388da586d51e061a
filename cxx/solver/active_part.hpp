#pragma once
// Factor of a part of a dense matrix; the part changes by a few rows at a time.
#include <Eigen/Dense>
#include <functional>
#include <memory>
#include <vector>

namespace burnish {

/// Keeps the factor of C over the selected indices: L L' of a symmetric positive definite matrix, L U of another one. A selection
/// that was made before costs nothing; one that differs by few indices takes them out of L L' and appends them to it; else the
/// part is factorized anew.
class ActivePart {
public:
  /// @param updates_from  size of the part from which on the factor is updated; below, a new one is as cheap
  explicit ActivePart(int updates_from = 400) : m_updates_from(updates_from) {}
  /// Makes sure that these columns of the matrix are there.
  using Complete = std::function<void(const std::vector<int>&)>;
  /// A matrix; the factor made before is forgotten.
  /// @param symmetric it is so, and its parts are positive definite
  /// @param complete called before columns are read; empty: they are all there
  void set(std::shared_ptr<const Eigen::MatrixXd> matrix, bool symmetric = true, Complete complete = {});
  const Eigen::MatrixXd& matrix() const { return *m_matrix; }
  /// Makes the part over these indices (each once) current.
  /// @returns false if it is not positive definite, or is singular; then there is no factor
  bool select(const std::vector<int>& indices);
  /// C_aa^-1 B for the current part; with many columns by the inverse, which is kept with the factor: B is mostly zeros then, three entries
  /// a column. @param B rows in the order of the last selection
  Eigen::MatrixXd solve(const Eigen::MatrixXd& B) const;
  long factorizations() const { return m_factorizations; }
  long updates() const { return m_updates; } ///< rows taken out or appended

private:
  bool factorize();
  bool append(int index);
  void remove(Eigen::Index position);
  bool update(const std::vector<int>& indices);

  int m_updates_from;
  bool m_symmetric = true;
  Complete m_complete;
  Eigen::PartialPivLU<Eigen::MatrixXd> m_lu; // unless symmetric
  std::shared_ptr<const Eigen::MatrixXd> m_matrix;
  Eigen::MatrixXd m_lower;           // the leading m_order.size() rows count
  mutable Eigen::MatrixXd m_inverse; // of m_lower's matrix, empty: not asked for yet
  std::vector<int> m_order;          // indices in the order of the factor
  std::vector<int> m_selected;       // as asked for
  std::vector<Eigen::Index> m_place; // per selected index: its row in the factor
  long m_factorizations = 0, m_updates = 0;
};

} // namespace burnish
