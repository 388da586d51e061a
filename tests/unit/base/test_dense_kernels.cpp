// Products and factors of the contact block, small by Eigen and large by LAPACK, against what they stand for.
#include "base/dense_kernels.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// Entries -1 .. 1 that do not depend on the machine.
Eigen::MatrixXd sample(Eigen::Index rows, Eigen::Index columns) {
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [columns](Eigen::Index i, Eigen::Index j) {
    const auto k = static_cast<double>(i * columns + j);
    return std::sin(k * k + 0.7 * k);
  });
}

Eigen::MatrixXd positive(Eigen::Index n) {
  const Eigen::MatrixXd A = sample(n, n);
  return A * A.transpose() / static_cast<double>(n) + Eigen::MatrixXd::Identity(n, n);
}

class DenseKernels : public testing::TestWithParam<Eigen::Index> {};

TEST_P(DenseKernels, CholeskyAndInverse) {
  const Eigen::Index n = GetParam();
  const Eigen::MatrixXd C = positive(n), B = sample(n, 5);
  Eigen::MatrixXd L = C, X = B;
  ASSERT_TRUE(cholesky(L));
  L.triangularView<Eigen::StrictlyUpper>().setConstant(1e300); // is not read
  L.conservativeResize(n + 7, n + 7);
  const MatrixPart lower{L.data(), static_cast<int>(n), static_cast<int>(n), static_cast<int>(n + 7)};
  solve_lower(lower, false, X);
  solve_lower(lower, true, X);
  EXPECT_LT((C * X - B).norm(), 1e-12 * B.norm());
  if (n >= LARGE_BLOCK) {
    EXPECT_LT((inverse_from_cholesky(L, n) * B - X).norm(), 1e-12 * X.norm());
  }
  Eigen::MatrixXd indefinite = C;
  indefinite(n - 1, n - 1) = -1;
  EXPECT_FALSE(cholesky(indefinite));
}

TEST_P(DenseKernels, ProductAndSolution) {
  const Eigen::Index n = GetParam();
  Eigen::MatrixXd A = sample(n, n), W = sample(n, n / 2);
  for (Eigen::Index j = 0; j < W.cols(); ++j) // three entries a column
    for (Eigen::Index i = 0; i < n; ++i)
      if (i < 2 * j || i > 2 * j + 2) W(i, j) = 0;
  EXPECT_LT((transposed_product(W, A) - W.transpose() * A).norm(), 1e-14 * A.norm() * W.norm());
  const Eigen::VectorXd b = sample(n, 1);
  Eigen::VectorXd x = b;
  ASSERT_TRUE(solve_regular(A, 1e-15, x));
  EXPECT_LT((A * x - b).norm(), 1e-10 * A.norm() * x.norm());
  A.col(1) = A.col(0);
  x = b;
  EXPECT_FALSE(solve_regular(A, 1e-15, x));
  EXPECT_EQ(x, b);
}

INSTANTIATE_TEST_SUITE_P(SmallAndLarge, DenseKernels, testing::Values(40, LARGE_BLOCK + 50));

} // namespace
