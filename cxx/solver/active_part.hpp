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
  /// A matrix that is known in parts.
  struct Parts {
    std::function<std::vector<int>(const std::vector<int>&)>
        places; ///< makes sure of the part over indices, and says where it stands
    std::function<Eigen::VectorXd(const Eigen::VectorXd&)> times; ///< product of the whole matrix
  };
  /// A matrix; the factor made before is forgotten.
  /// @param symmetric it is so, and its parts are positive definite
  /// @param parts empty: the matrix is there as a whole
  void set(std::shared_ptr<const Eigen::MatrixXd> matrix, bool symmetric = true, Parts parts = {});
  /// y += C x. @param x, y as many numbers as the whole matrix has rows; x is zero but on the current part
  void add_product(const Eigen::VectorXd& x, Eigen::VectorXd& y) const;
  /// C_ij; 0 unless i and j are of the current part.
  double entry(int i, int j) const;
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
  bool append(int place);
  void remove(Eigen::Index position);
  bool update(const std::vector<int>& places);

  int m_updates_from;
  bool m_symmetric = true;
  Parts m_parts;
  Eigen::PartialPivLU<Eigen::MatrixXd> m_lu; // unless symmetric
  std::shared_ptr<const Eigen::MatrixXd> m_matrix;
  Eigen::MatrixXd m_lower;           // the leading m_order.size() rows count
  mutable Eigen::MatrixXd m_inverse; // of m_lower's matrix, empty: not asked for yet
  std::vector<int> m_order;          // places in the matrix in the order of the factor
  std::vector<int> m_stands;         // per index: its place in the matrix, -1: not selected
  std::vector<int> m_selected;       // as asked for
  std::vector<Eigen::Index> m_place; // per selected index: its row in the factor
  long m_factorizations = 0, m_updates = 0;
};

} // namespace burnish
