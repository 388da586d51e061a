#include "solver/unsymmetric_solver.hpp"
#include "unit/solver/sparse_sample.hpp"
#include <gtest/gtest.h>
#include <limits>

using namespace burnish;

namespace {

void expect_solves(UnsymmetricSolver& solver, const Eigen::MatrixXd& full, const sample::Sparse& matrix) {
  ASSERT_EQ(solver.factorize(matrix.view()), FactorStatus::OK);
  const Eigen::VectorXd b = sample::random_vector(matrix.n());
  EXPECT_LT((full * solver.solve(b) - b).norm(), 1e-12 * b.norm());
  EXPECT_LT((full.transpose() * solver.solve_transposed(b) - b).norm(), 1e-12 * b.norm());
}

/// Diagonally dominant, symmetric neither in values nor in pattern.
Eigen::MatrixXd random_matrix(int n) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> value(-1., 1.);
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i) {
    full(i, i) = 5.;
    for (int k = 0; k < 4; ++k) full(i, random() % n) += value(random);
  }
  return full;
}

} // namespace

TEST(UnsymmetricSolver, GeneralMatrixAndItsTranspose) {
  const Eigen::MatrixXd full = random_matrix(80);
  UnsymmetricSolver solver;
  expect_solves(solver, full, sample::sparse(full));
}

TEST(UnsymmetricSolver, RatioOfThePivots) {
  Eigen::MatrixXd full = Eigen::Vector3d(2, 8, 4).asDiagonal();
  UnsymmetricSolver solver;
  EXPECT_EQ(solver.rcond(), 0);
  ASSERT_EQ(solver.factorize(sample::sparse(full).view()), FactorStatus::OK);
  EXPECT_GT(solver.rcond(), 0.1);
  full << 1, 1, 0, 1, 1 + 1e-14, 0, 0, 0, 1;
  ASSERT_EQ(solver.factorize(sample::sparse(full).view()), FactorStatus::OK);
  EXPECT_LT(solver.rcond(), 1e-12);
}

TEST(UnsymmetricSolver, EitherTriangleOfASymmetricMatrix) {
  const Eigen::MatrixXd full = sample::symmetric_matrix();
  UnsymmetricSolver solver;
  expect_solves(solver, full,
                sample::sparse(
                    full, [](int i, int j) { return i >= j; }, true));
  expect_solves(solver, full,
                sample::sparse(
                    full, [](int i, int j) { return i <= j; }, true));
  EXPECT_EQ(solver.analyses(), 2);
}

TEST(UnsymmetricSolver, TriangularMatrixIsNotTakenForHalfOfASymmetricOne) {
  Eigen::MatrixXd full = sample::symmetric_matrix(2, 3);
  sample::Sparse matrix = sample::sparse(
      full, [](int i, int j) { return i >= j; }, true);
  UnsymmetricSolver solver;
  expect_solves(solver, full, matrix);
  matrix.symmetric = false; // the same arrays
  full.triangularView<Eigen::StrictlyUpper>().setZero();
  expect_solves(solver, full, matrix);
}

TEST(UnsymmetricSolver, AnalysisIsKeptWhileThePatternIsTheSame) {
  Eigen::MatrixXd full = random_matrix(50);
  UnsymmetricSolver solver;
  expect_solves(solver, full, sample::sparse(full));
  full *= -3.;
  full.row(7) *= 2.;
  expect_solves(solver, full, sample::sparse(full));
  EXPECT_EQ(solver.analyses(), 1);
  full(3, 40) += 1.;
  full(40, 3) += 1.;
  full(41, 3) += 1.;
  expect_solves(solver, full, sample::sparse(full));
  EXPECT_EQ(solver.analyses(), 2);
  UnsymmetricSolver moved = std::move(solver);
  expect_solves(moved, full, sample::sparse(full));
  EXPECT_EQ(moved.analyses(), 2);
}

TEST(UnsymmetricSolver, SingularIsAStatus) {
  Eigen::MatrixXd full = random_matrix(30);
  UnsymmetricSolver solver;
  const Eigen::VectorXd b = sample::random_vector(30);
  sample::Sparse matrix = sample::sparse(full);
  ASSERT_EQ(solver.factorize(matrix.view()), FactorStatus::OK);
  std::fill(matrix.value.begin() + matrix.row_start[4], matrix.value.begin() + matrix.row_start[5], 0.);
  EXPECT_EQ(solver.factorize(matrix.view()), FactorStatus::SINGULAR);
  EXPECT_THROW(solver.solve(b), std::invalid_argument);
  full.col(9).setZero(); // structurally
  EXPECT_EQ(solver.factorize(sample::sparse(full).view()), FactorStatus::SINGULAR);
}

TEST(UnsymmetricSolver, RefusesBadNumbersAndSizes) {
  UnsymmetricSolver solver;
  EXPECT_THROW(solver.solve(Eigen::VectorXd::Zero(3)), std::invalid_argument);
  sample::Sparse matrix = sample::sparse(random_matrix(10));
  ASSERT_EQ(solver.factorize(matrix.view()), FactorStatus::OK);
  EXPECT_THROW(solver.solve(Eigen::VectorXd::Zero(3)), std::invalid_argument);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(10);
  b[9] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(solver.solve_transposed(b), std::invalid_argument);
  matrix.value.back() = std::numeric_limits<double>::infinity();
  EXPECT_THROW(solver.factorize(matrix.view()), std::invalid_argument);
  EXPECT_THROW(solver.solve(Eigen::VectorXd::Zero(10)), std::invalid_argument); // no factor any more
}

TEST(SparseView, RefusesBadPatterns) {
  // the two general solvers share this check
  const auto attempt = [](int n, std::vector<int> row_start, std::vector<int> col, bool symmetric = false) {
    const std::vector<double> value(col.size(), 1.);
    UnsymmetricSolver().factorize({n, row_start.data(), col.data(), value.data(), symmetric});
  };
  EXPECT_NO_THROW(attempt(2, {0, 2, 3}, {0, 1, 1}));
  EXPECT_THROW(attempt(0, {0}, {}), std::invalid_argument);
  EXPECT_THROW(attempt(2, {1, 2, 3}, {0, 0, 1}), std::invalid_argument); // does not start at 0
  EXPECT_THROW(attempt(2, {0, 2, 1}, {0, 1}), std::invalid_argument);    // descending
  EXPECT_THROW(attempt(2, {0, 1, 2}, {0, 2}), std::invalid_argument);    // column out of range
  EXPECT_THROW(attempt(2, {0, 1, 2}, {-1, 1}), std::invalid_argument);
  EXPECT_THROW(attempt(2, {0, 2, 3}, {1, 0, 1}), std::invalid_argument);          // not ascending
  EXPECT_THROW(attempt(2, {0, 2, 3}, {0, 0, 1}), std::invalid_argument);          // repeated
  EXPECT_THROW(attempt(2, {0, 2, 4}, {0, 1, 0, 1}, true), std::invalid_argument); // both triangles
  const int row_start[] = {0, 1}, col[] = {0};
  const double value[] = {1.};
  EXPECT_THROW(UnsymmetricSolver().factorize({1, nullptr, col, value, false}), std::invalid_argument);
  EXPECT_THROW(UnsymmetricSolver().factorize({1, row_start, nullptr, value, false}), std::invalid_argument);
  EXPECT_THROW(UnsymmetricSolver().factorize({1, row_start, col, nullptr, false}), std::invalid_argument);
}

TEST(SparseView, NotFiniteValueIsNamedByItsPlace) {
  sample::Sparse matrix = sample::sparse(Eigen::MatrixXd::Identity(4, 4));
  matrix.value[2] = std::numeric_limits<double>::quiet_NaN();
  try {
    check_values("caller", matrix.view());
    FAIL() << "a NaN was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "caller: value of entry (row 2, column 2) = nan, expected a finite number");
  }
}

TEST(SparsePattern, MirrorPointsToTheOtherSide) {
  const std::vector<int> row_start{0, 2, 3, 5}, col{0, 2, 1, 1, 2};
  const std::vector<double> value(5, 1.);
  const SparsePattern pattern("test", {3, row_start.data(), col.data(), value.data(), false});
  EXPECT_EQ(pattern.mirror, (std::vector<int>{0, -1, 2, -1, 4}));
}
