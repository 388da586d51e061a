// The choice between the bordered and the general solver, the pool of solvers, and rows from entries in any order.
#include "solver/condensed_solver.hpp"
#include "solver/sparse_rows.hpp"
#include "unit/solver/sparse_sample.hpp"
#include <gtest/gtest.h>
#include <random>

using namespace burnish;
using namespace burnish::sample;

namespace {

/// Symmetric, positive definite, banded; `rows` of them made nonsymmetric.
Eigen::MatrixXd matrix(int n, int rows) {
  Eigen::MatrixXd A = 4 * Eigen::MatrixXd::Identity(n, n);
  for (int i = 0; i + 1 < n; ++i) A(i, i + 1) = A(i + 1, i) = -1;
  for (int r = 0; r < rows; ++r) A(r, n - 1) += 0.5;
  return A;
}

} // namespace

TEST(CondensedSolver, SolvesWhateverTheSymmetry) {
  CondensedSolver solver;
  for (const int rows : {0, 2, 40}) {
    const Eigen::MatrixXd A = matrix(40, rows);
    ASSERT_EQ(solver.factorize(sparse(A).view()), FactorStatus::OK);
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(40, -1, 2);
    EXPECT_LE((A * solver.solve(b) - b).norm(), 1e-13 * b.norm()) << rows;
    EXPECT_LE((A.transpose() * solver.solve(b, true) - b).norm(), 1e-13 * b.norm()) << rows;
  }
  ASSERT_EQ(solver.factorize(sparse(matrix(40, 0)).view()), FactorStatus::OK);
  EXPECT_TRUE(solver.bordered());
  Eigen::MatrixXd indefinite = -matrix(40, 0);
  ASSERT_EQ(solver.factorize(sparse(indefinite).view()), FactorStatus::OK);
  EXPECT_FALSE(solver.bordered());
}

TEST(CondensedSolver, SingularIsReported) {
  Eigen::MatrixXd A = matrix(6, 0);
  A.row(2).setZero();
  A.col(2).setZero();
  CondensedSolver solver;
  EXPECT_NE(solver.factorize(sparse(A).view()), FactorStatus::OK);
}

TEST(SolverPool, KeepsAFewAnalyses) {
  SolverPool pool;
  const auto first = pool.take();
  EXPECT_NE(first, nullptr);
  for (std::size_t k = 0; k < SolverPool::most + 2; ++k) pool.give_back(std::make_unique<CondensedSolver>());
  EXPECT_EQ(pool.waiting(), SolverPool::most);
  pool.take();
  EXPECT_EQ(pool.waiting(), SolverPool::most - 1);
}

TEST(SparseRows, FromEntriesInAnyOrder) {
  const Sparse expected = sparse(matrix(12, 3));
  std::vector<int> row, col;
  std::vector<double> value;
  for (int i = 0; i < expected.n(); ++i)
    for (int k = expected.row_start[i]; k < expected.row_start[i + 1]; ++k) {
      row.push_back(i);
      col.push_back(expected.col[k]);
      value.push_back(expected.value[k]);
    }
  std::vector<std::size_t> order(row.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::shuffle(order.begin(), order.end(), std::mt19937(3));
  std::vector<int> row2, col2;
  std::vector<double> value2;
  for (const std::size_t k : order) {
    row2.push_back(row[k]);
    col2.push_back(col[k]);
    value2.push_back(value[k]);
  }
  const SparseRows rows = rows_of({12, value2.size(), row2.data(), col2.data(), value2.data(), false});
  EXPECT_EQ(rows.row_start, expected.row_start);
  EXPECT_EQ(rows.col, expected.col);
  EXPECT_EQ(rows.value, expected.value);
}

TEST(SparseRows, LowerTriangleOfBlocks) {
  NodeBlockMatrix<2> K = pattern_from_elements<2>(3, 3, {0, 1, 2});
  Eigen::MatrixXd full = Eigen::MatrixXd::Random(6, 6);
  full = (full + full.transpose()).eval();
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b)
      for (int c = 0; c < 4; ++c) K.block(K.find(a, b))[c] = full(2 * a + c / 2, 2 * b + c % 2);
  const SparseRows lower = lower_triangle(K);
  EXPECT_TRUE(lower.symmetric);
  Eigen::MatrixXd read = Eigen::MatrixXd::Zero(6, 6);
  for (int i = 0; i < 6; ++i)
    for (int k = lower.row_start[i]; k < lower.row_start[i + 1]; ++k) read(i, lower.col[k]) = lower.value[k];
  EXPECT_EQ(read, Eigen::MatrixXd(full.triangularView<Eigen::Lower>()));
}
