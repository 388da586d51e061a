#pragma once
// Decompositions of small dense matrices, compiled once for all who ask: Eigen's templates are the slowest part of a build.
#include <Eigen/Core>

namespace burnish {

struct SymmetricEigen {
  Eigen::VectorXd values;  ///< growing [unit of the matrix]
  Eigen::MatrixXd vectors; ///< columns in their order, orthonormal [-]
};

/// A = V diag(values) V'.
/// @param A [n x n] symmetric; only the lower triangle is read
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A);

/// The least real part of the eigenvalues of a square matrix [unit of the matrix], by LAPACK; NaN if they are not found.
/// @param A [n x n] finite, n > 0
double least_real_part(Eigen::MatrixXd A);

struct RightSingular {
  Eigen::VectorXd values;  ///< falling, min(rows, columns) of them [unit of the matrix]
  Eigen::MatrixXd vectors; ///< [columns x columns] columns in their order, orthonormal [-]
};

/// Singular values of A and what A multiplies them by, A V = U diag(values), by LAPACK; NaN if they are not found.
/// @param A [rows x columns] finite, neither zero
RightSingular right_singular(Eigen::MatrixXd A);

/// The weights of the value at the origin of a linear fit: the first column of the inverse of its normal matrix [-].
/// @param normal sum over the points of w r r' with r = (1, coordinates), positive definite
template <int Terms>
Eigen::Matrix<double, Terms, 1> first_of_inverse(const Eigen::Matrix<double, Terms, Terms>& normal);

} // namespace burnish
