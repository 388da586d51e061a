#pragma once
// The products and factors of the contact block: Eigen's where it is small, those of BLAS and LAPACK where it is large.
#include <Eigen/Core>

namespace burnish {

/// Rows from which on LAPACK takes no more than half of the time of Eigen, which is compiled for any machine of its kind: L L' of 256 rows
/// .23 for .49 ms, of 1024 rows 11 for 30; L U of 2048 rows 160 for 1060.
constexpr Eigen::Index LARGE_BLOCK = 64;

/// A = L L' in place; only the lower triangle is read and written. @returns false if A is not positive definite
/// @param A [n x n] symmetric
bool cholesky(Eigen::MatrixXd& A);

/// (L L')^-1. @param L its leading lower triangle of n rows counts
Eigen::MatrixXd inverse_from_cholesky(const Eigen::MatrixXd& L, Eigen::Index n);

/// A' B; where A is large it is taken for mostly zeros. @param A [n x rows] @param B [n x columns]
Eigen::MatrixXd transposed_product(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

/// A dense matrix within a larger one, column by column.
struct MatrixPart {
  const double* values;
  int rows, columns, stride; ///< stride: from one column to the next
};
/// C = A B or A' B. @param B and C, which is as large as the product, are whole
void multiply(const MatrixPart& A, bool transposed, const Eigen::MatrixXd& B, Eigen::MatrixXd& C);

/// X = L^-1 X or L'^-1 X. @param L its lower triangle counts, as many rows as X has @param X [n x columns]
void solve_lower(const MatrixPart& L, bool transposed, Eigen::MatrixXd& X);

/// x = A^-1 x, by rows' pivots. @returns false if a pivot is 0 or the reciprocal of A's condition number (estimated, in the norm of
/// column sums) is no more than `least` [-]; x is as it was then
/// @param A [n x n] @param x [n]
bool solve_regular(const Eigen::MatrixXd& A, double least, Eigen::VectorXd& x);

} // namespace burnish
