#pragma once
// The rows of the free dofs of a node-block matrix, as a general sparse solver takes them.
#include "solver/sparse_rows.hpp"
#include <cstdint>

namespace burnish {

template <int Dim> class FreeRows {
public:
  FreeRows() = default;
  /// @param fixed Dim*num_nodes flags, nonzero: left out @param half only the lower triangle, of a solver of symmetric matrices
  FreeRows(const NodeBlockMatrix<Dim>& pattern, const std::vector<char>& fixed, bool half);
  void take_values(const NodeBlockMatrix<Dim>& K);
  void add_to_diagonal(int row, double value) { m_rows.value[m_diagonal[row]] += value; }

  SparseView view() const { return m_rows.view(); }
  int size() const { return m_rows.n; }
  /// Row of a dof, -1: it is fixed.
  int row_of(int dof) const { return m_place[dof]; }
  Eigen::VectorXd product(const Eigen::VectorXd& x) const;
  /// Of all dofs -> of the free ones.
  /// @param where the caller's name for messages @throws std::invalid_argument if b has another size or a free entry is not finite
  Eigen::VectorXd gathered(const Eigen::VectorXd& b, const char* where) const;
  /// Of the free dofs -> of all, zero at the fixed ones.
  Eigen::VectorXd scattered(const Eigen::VectorXd& x) const;

private:
  SparseRows m_rows;
  std::vector<int> m_free, m_place;
  std::vector<std::uint32_t> m_slot; // per entry, its place in NodeBlockMatrix::value
  std::vector<int> m_diagonal;       // per row
};

} // namespace burnish
