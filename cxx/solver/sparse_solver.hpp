#pragma once
// A sparse solver as ColumnFactor uses it: CHOLMOD, or one of the host program.
#include "solver/half_columns.hpp"
#include "solver/sparse_view.hpp"
#include <memory>

namespace burnish {

/// One matrix at a time, any number of right-hand sides. What such a solver says of failures is not relied on: ColumnFactor looks
/// at the residual.
class SparseSolver {
public:
  virtual ~SparseSolver() = default;
  /// It takes one triangle of a symmetric matrix, the lower one by rows; others take the whole matrix.
  virtual bool symmetric() const = 0;
  /// The pattern of the matrices to come; its values are not read. What was kept of another pattern is gone.
  virtual void analyze(const SparseView& pattern) = 0;
  /// @param value in the order of the pattern
  /// @returns false where the solver itself says that it has no factor
  virtual bool factorize(const double* value) = 0;
  /// Replaces every column of B, n rows, by A^-1 B.
  virtual void solve(Eigen::MatrixXd& B) = 0;
  /// Columns of L^-1 of a factor L L' that can be read; null: there is none. Valid until the next factorize.
  virtual std::unique_ptr<HalfColumns> half_columns() const { return nullptr; }
  /// L'^-1 y of such a factor. @param y in the order of L @returns in the order of the matrix
  virtual Eigen::VectorXd second_half(Eigen::VectorXd y) const { return y; }
  virtual std::size_t factor_entries() const { return 0; } ///< numbers stored; 0: not known
};

} // namespace burnish
