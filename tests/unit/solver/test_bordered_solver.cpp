#include "solver/bordered_solver.hpp"
#include "solver/unsymmetric_solver.hpp"
#include "unit/solver/sparse_sample.hpp"
#include <gtest/gtest.h>
#include <limits>

using namespace burnish;

namespace {

/// Both solutions against dense LU and UMFPACK.
void expect_solves(BorderedSolver& solver, const Eigen::MatrixXd& full, const sample::Sparse& matrix) {
  ASSERT_EQ(solver.factorize(matrix.view()), FactorStatus::OK);
  UnsymmetricSolver check;
  ASSERT_EQ(check.factorize(matrix.view()), FactorStatus::OK);
  const Eigen::VectorXd b = sample::random_vector(matrix.n());
  const Eigen::VectorXd x = full.partialPivLu().solve(b), y = full.transpose().partialPivLu().solve(b);
  EXPECT_LT((solver.solve(b) - x).norm(), 1e-9 * x.norm());
  EXPECT_LT((solver.solve(b) - check.solve(b)).norm(), 1e-9 * x.norm());
  EXPECT_LT((full * solver.solve(b) - b).norm(), 1e-11 * b.norm());
  EXPECT_LT((solver.solve_transposed(b) - y).norm(), 1e-9 * y.norm());
  EXPECT_LT((solver.solve_transposed(b) - check.solve_transposed(b)).norm(), 1e-9 * y.norm());
}

} // namespace

TEST(BorderedSolver, SymmetricMatrixHasNoBorder) {
  const Eigen::MatrixXd full = sample::symmetric_matrix();
  BorderedSolver solver;
  expect_solves(solver, full, sample::sparse(full));
  EXPECT_EQ(solver.border_size(), 0);
}

TEST(BorderedSolver, EitherTriangleOfASymmetricMatrix) {
  const Eigen::MatrixXd full = sample::symmetric_matrix();
  BorderedSolver solver;
  expect_solves(solver, full,
                sample::sparse(
                    full, [](int i, int j) { return i >= j; }, true));
  EXPECT_EQ(solver.border_size(), 0);
  expect_solves(solver, full,
                sample::sparse(
                    full, [](int i, int j) { return i <= j; }, true));
  EXPECT_EQ(solver.analyses(), 2);
}

TEST(BorderedSolver, NonsymmetricRowsOrColumnsAreTheBorder) {
  const std::vector<int> rows{0, 7, 8, 41, 90};
  const Eigen::MatrixXd full = sample::with_friction_rows(sample::symmetric_matrix(), rows);
  BorderedSolver solver;
  expect_solves(solver, full, sample::sparse(full));
  EXPECT_EQ(solver.border_size(), 5);
  const Eigen::MatrixXd columns = full.transpose();
  expect_solves(solver, columns, sample::sparse(columns));
  EXPECT_EQ(solver.border_size(), 5);
}

TEST(BorderedSolver, EntriesStoredOnOneSideOnly) {
  Eigen::MatrixXd full = sample::symmetric_matrix();
  const int last = static_cast<int>(full.rows()) - 1;
  for (int j = 0; j < 60; j += 3) full(last, j) += 0.1; // a long row without its column
  ASSERT_EQ(full(0, last), 0.);
  full(3, last - 20) = 0.2; // a single entry above the diagonal
  ASSERT_EQ(full(last - 20, 3), 0.);
  BorderedSolver solver;
  expect_solves(solver, full, sample::sparse(full));
  EXPECT_EQ(solver.border_size(), 2);
}

TEST(BorderedSolver, ZeroStoredOnOneSideOfTheRestIsSymmetric) {
  Eigen::MatrixXd full = sample::symmetric_matrix();
  const int last = static_cast<int>(full.rows()) - 1;
  full(0, last) = 1.; // marks the place
  sample::Sparse matrix = sample::sparse(full);
  matrix.value[matrix.row_start[1] - 1] = 0.;
  full(0, last) = 0.;
  BorderedSolver solver;
  expect_solves(solver, full, matrix);
  EXPECT_EQ(solver.border_size(), 0);
}

TEST(BorderedSolver, LargeBorderOfSeveralPanelsAndDiagonalRows) {
  Eigen::MatrixXd full = sample::symmetric_matrix(4, 10);
  std::vector<int> rows;
  for (int i = 1; i < full.rows(); i += 4) rows.push_back(i);
  for (int i : {5, 30, 31}) { // rows that are only a diagonal entry
    full.row(i).setZero();
    full.col(i).setZero();
    full(i, i) = 1e3;
  }
  rows.erase(std::remove(rows.begin(), rows.end(), 5), rows.end());
  rows.erase(std::remove(rows.begin(), rows.end(), 30), rows.end());
  rows.erase(std::remove(rows.begin(), rows.end(), 31), rows.end());
  full = sample::with_friction_rows(full, rows);
  BorderedSolver solver;
  expect_solves(solver, full, sample::sparse(full));
  EXPECT_LE(solver.border_size(), static_cast<int>(rows.size()));
  EXPECT_GT(solver.border_size(), 64);
}

TEST(BorderedSolver, IndefiniteOrZeroDiagonalInsideTheBorder) {
  Eigen::MatrixXd full = sample::with_friction_rows(sample::symmetric_matrix(), {10, 20});
  full(10, 10) = 0.;
  full(20, 20) = -5.;
  BorderedSolver solver;
  expect_solves(solver, full, sample::sparse(full));
  EXPECT_EQ(solver.border_size(), 2);
}

TEST(BorderedSolver, BorderRowsOfVeryDifferentUnits) {
  Eigen::MatrixXd full = sample::with_friction_rows(sample::symmetric_matrix(), {10, 20, 33});
  full.row(10) *= 1e9;
  full.row(20) *= 1e-9;
  full.col(33) *= 1e-6;
  const sample::Sparse matrix = sample::sparse(full);
  BorderedSolver solver;
  ASSERT_EQ(solver.factorize(matrix.view()), FactorStatus::OK);
  EXPECT_EQ(solver.border_size(), 3);
  const Eigen::VectorXd x = sample::random_vector(matrix.n());
  EXPECT_LT((solver.solve(full * x) - x).norm(), 1e-7 * x.norm());
  EXPECT_LT((full * solver.solve(full * x) - full * x).norm(), 1e-11 * (full * x).norm());
}

TEST(BorderedSolver, RoundingIsNoAsymmetryButMoreIs) {
  Eigen::MatrixXd full = sample::symmetric_matrix();
  full(4, 6) *= 1 + 4e-16;
  ASSERT_NE(full(4, 6), full(6, 4));
  BorderedSolver solver;
  expect_solves(solver, full, sample::sparse(full));
  EXPECT_EQ(solver.border_size(), 0);
  full(4, 6) += 1e-12 * full.row(4).cwiseAbs().maxCoeff();
  expect_solves(solver, full, sample::sparse(full));
  EXPECT_EQ(solver.border_size(), 1);
}

TEST(BorderedSolver, AsymmetryIsJudgedByTheSmallerRow) {
  // entries between a stiff and a soft row differ by little on the scale of the stiff one only
  Eigen::MatrixXd full(2, 2);
  full << 1e14, 0.5, 0.4, 1.;
  BorderedSolver solver;
  expect_solves(solver, full, sample::sparse(full));
  EXPECT_EQ(solver.border_size(), 1);
}

TEST(BorderedSolver, AnalysisIsKeptWhilePatternAndBorderServe) {
  const Eigen::MatrixXd base = sample::symmetric_matrix();
  const Eigen::MatrixXd pattern =
      sample::with_friction_rows(base, {2, 4, 6, 8}, 0.05).cwiseAbs() + base.cwiseAbs();
  BorderedSolver solver;
  const auto expect_state = [&](const Eigen::MatrixXd& full, int analyses, int border_size) {
    expect_solves(solver, full, sample::stored_like(full, pattern));
    EXPECT_EQ(solver.analyses(), analyses);
    EXPECT_EQ(solver.border_size(), border_size);
  };
  expect_state(sample::with_friction_rows(base, {2, 4, 6, 8}), 1, 4);
  expect_state(sample::with_friction_rows(base, {2, 4, 6, 8}, -0.1), 1, 4); // other values
  expect_state(sample::with_friction_rows(base, {2, 8}), 1, 4);             // still half of the border
  expect_state(sample::with_friction_rows(base, {2}), 2, 1);                // a quarter of it
  expect_state(sample::with_friction_rows(base, {2, 6}), 3, 2);             // not covered
  expect_state(base, 4, 0);                                                 // no longer needed
  const Eigen::MatrixXd other = sample::symmetric_matrix(2, 3);
  expect_solves(solver, other, sample::sparse(other));
  EXPECT_EQ(solver.analyses(), 5);
}

TEST(BorderedSolver, StatusesLeaveNoFactorAndDoNotStick) {
  const Eigen::MatrixXd good = sample::with_friction_rows(sample::symmetric_matrix(), {10, 20});
  const Eigen::VectorXd b = sample::random_vector(static_cast<int>(good.rows()));
  BorderedSolver solver(3);
  Eigen::MatrixXd bad = good;
  bad(50, 50) = -1.;
  EXPECT_EQ(solver.factorize(sample::sparse(bad).view()), FactorStatus::NOT_POSITIVE_DEFINITE);
  EXPECT_THROW(solver.solve(b), std::invalid_argument);
  for (double part : {0.1, 0.23, 0.37, 0.6, 0.9}) { // singular within rounding, not always exactly
    bad = sample::with_friction_rows(good, {30});
    bad.row(20) = part * bad.row(10) + 0.71 * bad.row(30);
    EXPECT_EQ(solver.factorize(sample::sparse(bad).view()), FactorStatus::SINGULAR) << part;
  }
  EXPECT_THROW(solver.solve_transposed(b), std::invalid_argument);
  bad = sample::with_friction_rows(good, {30, 40, 50});
  EXPECT_EQ(solver.factorize(sample::sparse(bad).view()), FactorStatus::BORDER_TOO_LARGE);
  EXPECT_EQ(solver.border_size(), 0);
  EXPECT_THROW(solver.solve(b), std::invalid_argument);
  expect_solves(solver, good, sample::sparse(good));
}

TEST(BorderedSolver, ZeroRowOfTheSchurComplementIsSingular) {
  Eigen::MatrixXd full(3, 3); // row 1 is zero, its column is not
  full << 2., 1., 0., 0., 0., 0., 0., 1., 3.;
  EXPECT_EQ(BorderedSolver().factorize(sample::sparse(full).view()), FactorStatus::SINGULAR);
}

TEST(BorderedSolver, RefusesBadInput) {
  EXPECT_THROW(BorderedSolver(-1), std::invalid_argument);
  BorderedSolver solver;
  EXPECT_THROW(solver.solve(Eigen::VectorXd::Zero(2)), std::invalid_argument);
  const Eigen::MatrixXd full = sample::symmetric_matrix(2, 2);
  sample::Sparse matrix = sample::sparse(full);
  ASSERT_EQ(solver.factorize(matrix.view()), FactorStatus::OK);
  EXPECT_THROW(solver.solve(Eigen::VectorXd::Zero(2)), std::invalid_argument);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(matrix.n());
  b[1] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(solver.solve(b), std::invalid_argument);
  EXPECT_THROW(solver.solve_transposed(b), std::invalid_argument);
  matrix.value[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(solver.factorize(matrix.view()), std::invalid_argument);
  EXPECT_THROW(solver.solve(Eigen::VectorXd::Zero(matrix.n())), std::invalid_argument); // no factor any more
}
