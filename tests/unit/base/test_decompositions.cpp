// Decompositions that are compiled once: eigenvalues, singular values, the fit's weights.
#include "base/decompositions.hpp"
#include <Eigen/Dense>
#include <cmath>
#include <gtest/gtest.h>

namespace {

using namespace burnish;

// Eigenvalues of a block triangular matrix are those of its blocks: 3 +- 4i, -2 and 7.
Eigen::MatrixXd with_known_eigenvalues() {
  Eigen::MatrixXd A(4, 4);
  A << 3, 4, 5, 6, -4, 3, 7, 8, 0, 0, -2, 9, 0, 0, 0, 7;
  return A;
}

TEST(Decompositions, LeastRealPartIsThatOfTheKnownEigenvalues) {
  const Eigen::MatrixXd A = with_known_eigenvalues(), I = Eigen::MatrixXd::Identity(4, 4);
  EXPECT_NEAR(least_real_part(A), -2, 1e-12);
  EXPECT_NEAR(least_real_part(-A), -7, 1e-12);
  EXPECT_NEAR(least_real_part(A.topLeftCorner(2, 2)), 3, 1e-12);
  EXPECT_NEAR(least_real_part(A + 10 * I), 8, 1e-12);
  EXPECT_EQ(least_real_part(Eigen::MatrixXd::Constant(1, 1, -0.5)), -0.5);
}

// A V has orthogonal columns of the lengths of the values, of tall and of wide matrices.
TEST(Decompositions, SingularVectorsGiveOrthogonalImages) {
  for (const auto& [rows, columns] : {std::pair{6, 3}, {12, 5}, {2, 4}, {3, 3}}) {
    const Eigen::MatrixXd A = Eigen::MatrixXd::NullaryExpr(
        rows, columns, [](auto i, auto j) { return std::sin(1 + 3. * i + i * j); });
    const RightSingular found = right_singular(A);
    const Eigen::MatrixXd image = A * found.vectors, I = Eigen::MatrixXd::Identity(columns, columns);
    ASSERT_EQ(found.values.size(), std::min(rows, columns));
    EXPECT_LT((found.vectors.transpose() * found.vectors - I).norm(), 1e-13);
    for (int k = 0; k < columns; ++k)
      EXPECT_NEAR(image.col(k).norm(), k < found.values.size() ? found.values[k] : 0, 1e-13 * A.norm());
    for (int k = 1; k < found.values.size(); ++k) EXPECT_GE(found.values[k - 1], found.values[k]);
    EXPECT_LT(
        (image.transpose() * image - Eigen::MatrixXd(image.colwise().squaredNorm().asDiagonal())).norm(),
        1e-13 * A.squaredNorm());
  }
}

// The last vector of two columns that are alike is their difference.
TEST(Decompositions, DependentColumnsHaveAVectorWithoutImage) {
  Eigen::MatrixXd A(4, 2);
  A << 1, 2, 3, 6, -1, -2, 0.5, 1;
  const RightSingular found = right_singular(A);
  EXPECT_LT(found.values[1], 1e-15 * found.values[0] + 1e-15);
  EXPECT_NEAR(std::abs(found.vectors(0, 1) / found.vectors(1, 1)), 2, 1e-12);
  EXPECT_LT(found.vectors(0, 1) * found.vectors(1, 1), 0);
}

template <int Terms> void check_first_of_inverse() {
  Eigen::Matrix<double, Terms, Terms> A = Eigen::Matrix<double, Terms, Terms>::NullaryExpr(
      [](auto i, auto j) { return std::cos(1. * i + 2. * i * j + j); });
  const Eigen::Matrix<double, Terms, Terms> normal =
      A * A.transpose() + Eigen::Matrix<double, Terms, Terms>::Identity();
  EXPECT_LT((first_of_inverse<Terms>(normal) - normal.inverse().col(0)).norm(), 1e-14);
}
TEST(Decompositions, WeightsOfAFitAreTheFirstColumnOfTheInverse) {
  check_first_of_inverse<3>();
  check_first_of_inverse<4>();
}

} // namespace
