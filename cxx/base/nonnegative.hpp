#pragma once
// Least squares with numbers that are not negative.
#include <Eigen/Core>

namespace burnish {

/// x >= 0 that makes |A x - b| least, by the active set of [LawsonHanson1974].
/// @param A [rows x columns], few rows @param b [rows]
/// @returns x [columns]
Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

} // namespace burnish
