#pragma once
// Eigenvalues and eigenvectors of a small symmetric matrix, compiled once for all who ask.
#include <Eigen/Core>

namespace burnish {

struct SymmetricEigen {
  Eigen::VectorXd values;  ///< growing [unit of the matrix]
  Eigen::MatrixXd vectors; ///< columns in their order, orthonormal [-]
};

/// A = V diag(values) V'.
/// @param A [n x n] symmetric; only the lower triangle is read
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A);

} // namespace burnish
