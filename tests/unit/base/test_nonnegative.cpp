// Least squares with numbers that are not negative: the conditions of Karush, Kuhn and Tucker, which only the least fulfills.
#include "base/nonnegative.hpp"
#include <gtest/gtest.h>

using namespace burnish;

namespace {

void expect_least(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  const Eigen::VectorXd x = nonnegative_least_squares(A, b), left = b - A * x;
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    const double slope = A.col(j).dot(left) / (A.col(j).norm() * b.norm());
    EXPECT_GE(x[j], 0);
    EXPECT_LT(slope, 1e-9) << "column " << j;
    if (x[j] > 0) EXPECT_GT(slope, -1e-9) << "column " << j;
  }
}

} // namespace

TEST(Nonnegative, LeastOverManyColumns) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    std::srand(seed);
    expect_least(Eigen::MatrixXd::Random(1 + seed % 6, 1 + seed % 37), Eigen::VectorXd::Random(1 + seed % 6));
  }
}

// Pressure at -1 and 1: a force at 0.5 balances, one at 1.2 does not.
TEST(Nonnegative, ForceOnATwoLeggedTable) {
  Eigen::MatrixXd A(2, 3);
  A << 1, 1, 1, -1, 1, 1;
  const Eigen::Vector2d within(1, 0.5), beyond(1, 1.2);
  EXPECT_LT((A * nonnegative_least_squares(A, within) - within).norm(), 1e-14);
  EXPECT_NEAR((A * nonnegative_least_squares(A, beyond) - beyond).norm(), 0.2 / std::sqrt(2.), 1e-14);
}
