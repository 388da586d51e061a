#pragma once
// A square sparse matrix by rows that keeps its own arrays.
#include "solver/node_block_matrix.hpp"
#include "solver/sparse_view.hpp"

namespace burnish {

struct SparseRows {
  int n = 0;
  bool symmetric = false; ///< one triangle stands for both
  std::vector<int> row_start, col;
  std::vector<double> value;
  SparseView view() const { return {n, row_start.data(), col.data(), value.data(), symmetric}; }
};

/// Rows of a matrix given by entries in any order, columns ascending; entries of one place stay beside each other.
SparseRows rows_of(const TripletView& entries);

/// Lower triangle of a symmetric block matrix, diagonal included, dof by dof.
template <int Dim> SparseRows lower_triangle(const NodeBlockMatrix<Dim>& K);
/// All rows of a block matrix, dof by dof.
template <int Dim> SparseRows all_rows(const NodeBlockMatrix<Dim>& K);

/// Place of every entry where the entries are ordered by columns, then rows.
std::vector<int> places_by_columns(const SparseView& rows);

} // namespace burnish
