#include "solver/cholmod_solver.hpp"
#include "solver/column_factor.hpp"
#include "solver/schur_factor.hpp"
#include "solver/umfpack_solver.hpp"
#include "unit/solver/elastic_sample.hpp"
#include <gtest/gtest.h>

using namespace burnish;

namespace {

struct Plane {
  sample::Mesh<2> mesh = sample::with_mid_nodes(sample::ring_sector(4, 8));
  NodeBlockMatrix<2> K = sample::stiffness(mesh, 0.);
  std::vector<char> fixed = sample::fix(K, mesh.inner);
  std::vector<int> candidates{0, 7, 31, 12};
};

Eigen::MatrixXd constrained(const NodeBlockMatrix<2>& matrix, const std::vector<char>& fixed) {
  Eigen::MatrixXd full = sample::dense(matrix);
  for (int i = 0; i < matrix.size(); ++i) {
    if (!fixed[i]) continue;
    full.row(i).setZero();
    full.col(i).setZero();
    full(i, i) = 1.;
  }
  return full;
}

// Not symmetric: what a law that is not associated makes of the tangent.
NodeBlockMatrix<2> skewed(NodeBlockMatrix<2> K) {
  for (int row = 0; row < K.num_nodes; ++row)
    for (int k = K.row_start[row]; k < K.row_start[row + 1]; ++k)
      if (K.col[k] > row)
        for (int i = 0; i < 4; ++i) K.block(k)[i] *= 1.3;
  return K;
}

void expect_equals_dense(ColumnFactor<2>& factor, const Plane& plane, const NodeBlockMatrix<2>& K) {
  factor.analyze(K, plane.fixed, plane.candidates);
  ASSERT_EQ(factor.factorize(K), FactorStatus::OK);
  const Eigen::MatrixXd inverse = constrained(K, plane.fixed).inverse();
  Eigen::VectorXd b = sample::random_vector(K.size()), clean = b;
  std::vector<int> dofs, components;
  for (const int node : plane.candidates)
    for (int c = 0; c < 2; ++c) {
      if (!plane.fixed[2 * node + c]) components.push_back(static_cast<int>(dofs.size()));
      dofs.push_back(2 * node + c);
    }
  for (int i = 0; i < K.size(); ++i)
    if (plane.fixed[i]) clean[i] = 0;
  const Eigen::VectorXd x = inverse * clean;
  EXPECT_LT((factor.solve(b) - x).norm(), 1e-10 * x.norm());
  const SweptLoad swept = factor.sweep(b);
  EXPECT_LT((factor.candidate_displacement(swept) - x(dofs)).norm(), 1e-10 * x.norm());
  const long before = factor.columns();
  const auto C = factor.candidate_flexibility();
  EXPECT_EQ(C->size(), 0) << "columns come when they are asked for";
  const std::size_t half = components.size() / 2;
  factor.complete_flexibility({components.begin() + half, components.end()});
  EXPECT_EQ(factor.columns() - before, static_cast<long>(components.size() - half));
  const std::vector<int> places = factor.complete_flexibility(components);
  const long known = factor.columns();
  Eigen::VectorXd p = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(dofs.size())),
                  sum = Eigen::VectorXd::Zero(K.size());
  for (const int i : components) sum[dofs[i]] = p[i] = std::cos(2. + i);
  const double size = inverse.norm();
  double worst = 0;
  for (std::size_t i = 0; i < components.size(); ++i)
    for (std::size_t j = 0; j < components.size(); ++j)
      worst = std::max(
          worst, std::abs((*C)(places[i], places[j]) - inverse(dofs[components[i]], dofs[components[j]])));
  EXPECT_LT(worst, 1e-10 * size);
  const Eigen::VectorXd under = inverse * sum;
  EXPECT_LT((factor.displacement_under(p) - under(dofs)).norm(), 1e-10 * under.norm());
  EXPECT_LT((factor.displacement(swept, p) - x - under).norm(), 1e-10 * (x + under).norm());
  p *= 2;
  EXPECT_LT((factor.displacement(swept, p) - x - 2 * under).norm(), 1e-10 * (x + under).norm());
  EXPECT_EQ(factor.columns(), known) << "nothing is solved for twice";
}

TEST(ColumnFactor, AgainstDenseAlgebraSymmetricAndNot) {
  Plane plane;
  ColumnFactor<2> factor(std::make_unique<UmfpackSolver>());
  expect_equals_dense(factor, plane, plane.K);
  EXPECT_TRUE(factor.symmetric());
  expect_equals_dense(factor, plane, skewed(plane.K));
  EXPECT_FALSE(factor.symmetric());
  plane.candidates = {3, 31};
  expect_equals_dense(factor, plane, plane.K);
  EXPECT_EQ(factor.analyses(), 1) << "another window or other values are no other pattern";
}

TEST(ColumnFactor, AddedStiffnessOnTheCandidates) {
  Plane plane;
  ColumnFactor<2> factor(std::make_unique<UmfpackSolver>());
  factor.analyze(plane.K, plane.fixed, plane.candidates);
  const Eigen::VectorXd added =
      Eigen::VectorXd::LinSpaced(8, 1, 2) * sample::dense(plane.K).cwiseAbs().maxCoeff();
  ASSERT_EQ(factor.factorize(plane.K, added), FactorStatus::OK);
  Eigen::MatrixXd full = constrained(plane.K, plane.fixed);
  Eigen::VectorXd b = sample::random_vector(plane.K.size());
  for (int i = 0; i < 8; ++i) {
    const int dof = 2 * plane.candidates[i / 2] + i % 2;
    if (!plane.fixed[dof]) full(dof, dof) += added[i];
  }
  for (int i = 0; i < plane.K.size(); ++i)
    if (plane.fixed[i]) b[i] = 0;
  const Eigen::VectorXd x = full.inverse() * b;
  EXPECT_LT((factor.solve(b) - x).norm(), 1e-10 * x.norm());
}

TEST(ColumnFactor, ByCholmodInItsOwnOrder) {
  Plane plane;
  ColumnFactor<2> factor(std::make_unique<CholmodSolver>());
  EXPECT_EQ(factor.factor_entries(), 0u);
  expect_equals_dense(factor, plane, plane.K);
  EXPECT_TRUE(factor.symmetric());
  EXPECT_GT(factor.factor_entries(), 0u);
  const Eigen::VectorXd b = sample::random_vector(plane.K.size());
  const Eigen::VectorXd x = factor.solve(b);
  SchurFactor<2> other;
  other.analyze(plane.K, plane.fixed, plane.candidates);
  ASSERT_EQ(other.factorize(plane.K), FactorStatus::OK);
  EXPECT_LT((x - other.solve(b)).norm(), 1e-11 * x.norm());
  NodeBlockMatrix<2> K = plane.K;
  K.block(K.find(plane.mesh.outer[0], plane.mesh.outer[0]))[0] *= -1;
  EXPECT_EQ(factor.factorize(K), FactorStatus::NOT_POSITIVE_DEFINITE);
  EXPECT_THROW(factor.solve(b), std::invalid_argument);
}

// More than go through the factor together, in no order, in calls of any size.
TEST(ColumnFactor, ManyColumnsByTheirHalfWays) {
  Plane plane;
  plane.candidates.clear();
  for (int k = 0; k < plane.K.num_nodes; ++k) plane.candidates.push_back(k * 37 % plane.K.num_nodes);
  ASSERT_GT(plane.K.num_nodes, 70);
  ASSERT_NE(plane.K.num_nodes % 37, 0);
  ColumnFactor<2> factor(std::make_unique<CholmodSolver>());
  expect_equals_dense(factor, plane, plane.K);
  const auto C = factor.candidate_flexibility();
  EXPECT_EQ((*C - C->transpose()).norm(), 0);
  ColumnFactor<2> again(std::make_unique<CholmodSolver>());
  again.analyze(plane.K, plane.fixed, plane.candidates);
  ASSERT_EQ(again.factorize(plane.K), FactorStatus::OK);
  again.solve_columns(factor.solved_columns());
  EXPECT_EQ(*again.candidate_flexibility(), *C) << "the same calls, the same bits";
}

TEST(ColumnFactor, TellsSingularAndIndefiniteMatrices) {
  Plane plane;
  ColumnFactor<2> factor(std::make_unique<UmfpackSolver>());
  factor.analyze(plane.K, plane.fixed, plane.candidates);
  NodeBlockMatrix<2> K = plane.K;
  for (double& value : K.value) value = -value;
  EXPECT_EQ(factor.factorize(K), FactorStatus::NOT_POSITIVE_DEFINITE);
  EXPECT_THROW(factor.solve(Eigen::VectorXd::Zero(K.size())), std::invalid_argument);
  for (double& value : K.value) value = 0;
  EXPECT_EQ(factor.factorize(K), FactorStatus::SINGULAR);
  for (double& value : K.value) value = std::nan("");
  EXPECT_THROW(factor.factorize(K), std::invalid_argument);
  EXPECT_EQ(factor.factorize(plane.K), FactorStatus::OK);
}

} // namespace
