#include "base/error.hpp"
#include "solver/schur_factor.hpp"
#include "unit/solver/elastic_sample.hpp"
#include <gtest/gtest.h>
#include <limits>

using namespace burnish;

namespace {

/// Dense matrix with unit rows and columns at fixed dofs: what the factor stands for.
template <int Dim>
Eigen::MatrixXd constrained(const NodeBlockMatrix<Dim>& matrix, const std::vector<char>& fixed) {
  Eigen::MatrixXd full = sample::dense(matrix);
  for (int i = 0; i < matrix.size(); ++i) {
    if (!fixed[i]) continue;
    full.row(i).setZero();
    full.col(i).setZero();
    full(i, i) = 1.;
  }
  return full;
}

template <int Dim> std::vector<int> dofs_of(const std::vector<int>& nodes) {
  std::vector<int> dofs;
  for (int node : nodes)
    for (int c = 0; c < Dim; ++c) dofs.push_back(Dim * node + c);
  return dofs;
}

/// Solve, Schur complement and flexibility against dense algebra.
template <int Dim>
void expect_equals_dense(SchurFactor<Dim>& factor, const NodeBlockMatrix<Dim>& matrix,
                         const std::vector<char>& fixed, const std::vector<int>& candidates) {
  factor.analyze(matrix, fixed, candidates);
  ASSERT_EQ(factor.factorize(matrix), FactorStatus::OK);
  const Eigen::MatrixXd full = constrained(matrix, fixed), inverse = full.inverse();
  Eigen::VectorXd b = sample::random_vector(matrix.size());
  const Eigen::VectorXd x = factor.solve(b); // b is not zero at the fixed dofs, the solution must be
  for (int i = 0; i < matrix.size(); ++i)
    if (fixed[i]) b[i] = 0.;
  EXPECT_LT((full * x - b).norm(), 1e-12 * b.norm());
  const std::vector<int> dofs = dofs_of<Dim>(candidates);
  const Eigen::MatrixXd block = inverse(dofs, dofs), schur = block.inverse();
  Eigen::MatrixXd flexibility = block;
  for (std::size_t i = 0; i < dofs.size(); ++i)
    if (fixed[dofs[i]]) flexibility(i, i) = 0.;
  const Eigen::MatrixXd C = *factor.candidate_flexibility(), S = factor.schur_complement();
  ASSERT_EQ(C.rows(), static_cast<int>(dofs.size()));
  ASSERT_EQ(S.rows(), static_cast<int>(dofs.size()));
  if (dofs.empty()) return;
  EXPECT_LT((C - flexibility).norm(), 1e-10 * flexibility.norm());
  EXPECT_LT((S - schur).norm(), 1e-10 * schur.norm());
  EXPECT_EQ(C, C.transpose());
  EXPECT_EQ(S, S.transpose());
  const Eigen::VectorXd p = sample::random_vector(static_cast<int>(dofs.size()));
  const SweptLoad swept = factor.sweep(b);
  Eigen::VectorXd sum = b;
  for (std::size_t i = 0; i < dofs.size(); ++i)
    if (!fixed[dofs[i]]) sum[dofs[i]] += p[static_cast<int>(i)];
  EXPECT_LT((factor.candidate_displacement(swept) - x(dofs)).norm(), 1e-11 * x.norm());
  const Eigen::VectorXd loaded = inverse * sum;
  EXPECT_LT((factor.displacement(swept, p) - loaded).norm(), 1e-11 * loaded.norm());
}

} // namespace

TEST(SchurFactor, PlaneEqualsDense) {
  const sample::ClampedSector plane;
  SchurFactor<2> factor;
  expect_equals_dense(factor, plane.K, plane.fixed, plane.mesh.outer);
}

TEST(SchurFactor, SpaceEqualsDense) {
  for (const sample::Mesh<3>& mesh : {sample::cube(4), sample::with_mid_nodes(sample::cube(2))}) {
    const NodeBlockMatrix<3> K = sample::stiffness(mesh, 0.);
    SchurFactor<3> factor;
    expect_equals_dense(factor, K, sample::fix(K, mesh.inner), mesh.outer);
  }
}

TEST(SchurFactor, CandidatesInAnyOrderAndPlace) {
  // candidates far apart, in the interior, with and without common neighbors
  const sample::ClampedSector plane;
  SchurFactor<2> factor;
  std::vector<int> all(plane.K.num_nodes);
  for (int node = 0; node < plane.K.num_nodes; ++node) all[node] = node;
  for (unsigned seed : {1u, 2u, 3u, 4u}) {
    std::shuffle(all.begin(), all.end(), std::mt19937(seed));
    const std::vector<int> some(all.begin(), all.begin() + 5 * seed * seed);
    expect_equals_dense(factor, plane.K, plane.fixed, some);
  }
  expect_equals_dense(factor, plane.K, plane.fixed, all); // nothing left in the interior
  expect_equals_dense(factor, plane.K, plane.fixed, {});
}

TEST(SchurFactor, FixedDofsAmongCandidates) {
  const sample::ClampedSector plane;
  std::vector<char> fixed = plane.fixed;
  std::vector<int> candidates = plane.mesh.outer;
  fixed[2 * candidates[1]] = 1;
  fixed[2 * candidates[4] + 1] = 1;
  fixed[2 * candidates[5]] = fixed[2 * candidates[5] + 1] = 1;
  candidates.push_back(plane.mesh.inner.front());
  SchurFactor<2> factor;
  expect_equals_dense(factor, plane.K, fixed, candidates);
}

TEST(SchurFactor, OneComponentOfInteriorNodesFixed) {
  const sample::ClampedSector plane;
  std::vector<char> fixed = plane.fixed;
  for (int node = 0; node < plane.K.num_nodes; node += 3) fixed[2 * node + node % 2] = 1;
  SchurFactor<2> factor;
  expect_equals_dense(factor, plane.K, fixed, plane.mesh.outer);
}

TEST(SchurFactor, BodyWithoutFixedDofsAndSeparateBodies) {
  sample::Mesh<2> mesh = sample::ring_sector(2, 3);
  const int num_nodes = static_cast<int>(mesh.node.size());
  const std::vector<int> first = mesh.connectivity;
  for (int node : first) mesh.connectivity.push_back(node + num_nodes);
  const std::vector<Vector<2>> nodes = mesh.node;
  mesh.node.insert(mesh.node.end(), nodes.begin(), nodes.end());
  const NodeBlockMatrix<2> K = sample::stiffness(mesh, 0.3);
  SchurFactor<2> factor;
  expect_equals_dense(factor, K, std::vector<char>(K.size(), 0), {mesh.outer[0], mesh.outer[1], num_nodes});
}

TEST(SchurFactor, EverythingFixedSolvesToZero) {
  const sample::ClampedSector plane;
  SchurFactor<2> factor;
  factor.analyze(plane.K, std::vector<char>(plane.K.size(), 1), {3});
  ASSERT_EQ(factor.factorize(plane.K), FactorStatus::OK);
  EXPECT_EQ(factor.solve(sample::random_vector(plane.K.size())), Eigen::VectorXd::Zero(plane.K.size()));
  EXPECT_EQ(*factor.candidate_flexibility(), Eigen::MatrixXd::Zero(2, 2));
  EXPECT_EQ(factor.schur_complement(), Eigen::MatrixXd::Identity(2, 2));
}

TEST(SchurFactor, UsesTheLowerTriangleOnly) {
  const sample::ClampedSector plane;
  NodeBlockMatrix<2> lower = plane.K;
  for (int row = 0; row < lower.num_nodes; ++row)
    for (int k = lower.row_start[row]; k < lower.row_start[row + 1]; ++k)
      for (int e = 0; e < 4; ++e)
        if (2 * row + e / 2 < 2 * lower.col[k] + e % 2) lower.block(k)[e] = -1e9;
  SchurFactor<2> factor, reference;
  factor.analyze(lower, plane.fixed, plane.mesh.outer);
  reference.analyze(plane.K, plane.fixed, plane.mesh.outer);
  ASSERT_EQ(factor.factorize(lower), FactorStatus::OK);
  ASSERT_EQ(reference.factorize(plane.K), FactorStatus::OK);
  const Eigen::VectorXd b = sample::random_vector(lower.size());
  EXPECT_EQ(factor.solve(b), reference.solve(b));
}

TEST(SchurFactor, AnalysisIsReusedUntilSomethingChanges) {
  sample::ClampedSector plane;
  SchurFactor<2> factor;
  expect_equals_dense(factor, plane.K, plane.fixed, plane.mesh.outer);
  EXPECT_EQ(factor.analyses(), 1);
  plane.K = sample::stiffness(plane.mesh, 0.5, 17); // other values
  expect_equals_dense(factor, plane.K, plane.fixed, plane.mesh.outer);
  EXPECT_EQ(factor.analyses(), 1);
  EXPECT_EQ(factor.factorizations(), 2);
  EXPECT_EQ(factor.solves(), 4);
  plane.mesh.outer.pop_back(); // other candidates
  expect_equals_dense(factor, plane.K, plane.fixed, plane.mesh.outer);
  EXPECT_EQ(factor.analyses(), 2);
  std::reverse(plane.mesh.outer.begin(), plane.mesh.outer.end()); // another order of them
  expect_equals_dense(factor, plane.K, plane.fixed, plane.mesh.outer);
  EXPECT_EQ(factor.analyses(), 3);
  plane.fixed[2 * plane.mesh.inner[3]] = 0; // other fixed dofs
  expect_equals_dense(factor, plane.K, plane.fixed, plane.mesh.outer);
  EXPECT_EQ(factor.analyses(), 4);
  const NodeBlockMatrix<2> small = sample::stiffness(sample::ring_sector(2, 2), 1.); // another pattern
  expect_equals_dense(factor, small, std::vector<char>(small.size(), 0), {0, 4});
  EXPECT_EQ(factor.analyses(), 5);
  EXPECT_EQ(factor.factorizations(), 6);
  EXPECT_EQ(factor.solves(), 12);
}

TEST(SchurFactor, PatternsOfEqualRowLengthsAreToldApart) {
  NodeBlockMatrix<2> first{4, {0, 2, 4, 6, 8}, {0, 1, 0, 1, 2, 3, 2, 3}, std::vector<double>(32, 0.)};
  NodeBlockMatrix<2> second{4, {0, 2, 4, 6, 8}, {0, 2, 1, 3, 0, 2, 1, 3}, std::vector<double>(32, 0.)};
  for (NodeBlockMatrix<2>* matrix : {&first, &second})
    for (int k = 0; k < 8; ++k)
      for (int i = 0; i < 2; ++i) matrix->block(k)[3 * i] = k == matrix->find(k / 2, k / 2) ? 3. : 1.;
  SchurFactor<2> factor;
  const std::vector<char> fixed(8, 0);
  expect_equals_dense(factor, first, fixed, {3});
  EXPECT_THROW(factor.factorize(second), std::invalid_argument);
  expect_equals_dense(factor, second, fixed, {3});
  EXPECT_EQ(factor.analyses(), 2);
}

TEST(SchurFactor, IndefiniteMatrixIsAStatusAndDoesNotStick) {
  const sample::ClampedSector plane;
  SchurFactor<2> factor;
  factor.analyze(plane.K, plane.fixed, plane.mesh.outer);
  EXPECT_EQ(factor.factorize(sample::stiffness(plane.mesh, -1.)), FactorStatus::NOT_POSITIVE_DEFINITE);
  EXPECT_THROW(factor.solve(sample::random_vector(plane.K.size())), std::invalid_argument);
  EXPECT_THROW(factor.candidate_flexibility(), std::invalid_argument);
  expect_equals_dense(factor, plane.K, plane.fixed, plane.mesh.outer);
  // negative in the last candidate only: the interior is positive definite, the Schur complement is not
  NodeBlockMatrix<2> last = plane.K;
  const int node = plane.mesh.outer.back();
  last.block(last.find(node, node))[3] = -1e-3;
  EXPECT_EQ(factor.factorize(last), FactorStatus::NOT_POSITIVE_DEFINITE);
  EXPECT_EQ(factor.analyses(), 1);
}

TEST(SchurFactor, AddedOnTheDiagonalOfCandidates) {
  sample::ClampedSector plane;
  const std::vector<int>& nodes = plane.mesh.outer;
  plane.fixed[2 * nodes[1] + 1] = 1;
  SchurFactor<2> factor, other;
  factor.analyze(plane.K, plane.fixed, nodes);
  other.analyze(plane.K, plane.fixed, nodes);
  Eigen::VectorXd added = Eigen::VectorXd::Zero(2 * static_cast<int>(nodes.size()));
  NodeBlockMatrix<2> sum = plane.K;
  for (const int i : {0, 2, 3, 5}) { // 3 is fixed: nothing is added there
    added[i] = 0.5 + i;
    sum.block(sum.find(nodes[i / 2], nodes[i / 2]))[3 * (i % 2)] += added[i];
  }
  ASSERT_EQ(factor.factorize(plane.K, added), FactorStatus::OK);
  ASSERT_EQ(other.factorize(sum), FactorStatus::OK);
  const Eigen::VectorXd b = sample::random_vector(plane.K.size()), x = factor.solve(b);
  EXPECT_EQ(x, other.solve(b));
  ASSERT_EQ(factor.factorize(plane.K), FactorStatus::OK);
  EXPECT_GT((factor.solve(b) - x).norm(), 1e-3 * x.norm()) << "nothing was added";
  EXPECT_THROW(factor.factorize(plane.K, added.head(2)), std::invalid_argument);
}

TEST(SchurFactor, NoTwoFactorsAreHeld) {
  const sample::ClampedSector plane;
  SchurFactor<2> factor;
  expect_equals_dense(factor, plane.K, plane.fixed, plane.mesh.outer);
  factor.analyze(plane.K, plane.fixed, {plane.mesh.outer[0]});
  EXPECT_THROW(factor.solve(sample::random_vector(plane.K.size())), std::invalid_argument);
  expect_equals_dense(factor, plane.K, plane.fixed, {plane.mesh.outer[0]});
}

TEST(SchurFactor, MovedObjectKeepsItsFactor) {
  const sample::ClampedSector plane;
  SchurFactor<2> first;
  first.analyze(plane.K, plane.fixed, plane.mesh.outer);
  ASSERT_EQ(first.factorize(plane.K), FactorStatus::OK);
  const Eigen::VectorXd b = sample::random_vector(plane.K.size()), x = first.solve(b);
  const SchurFactor<2> second = std::move(first);
  EXPECT_EQ(second.solve(b), x);
}

TEST(SchurFactor, RefusesBadAnalysisAndKeepsTheOldOne) {
  const sample::ClampedSector plane;
  SchurFactor<2> factor;
  expect_equals_dense(factor, plane.K, plane.fixed, plane.mesh.outer);
  const int n = plane.K.num_nodes;
  EXPECT_THROW(factor.analyze(plane.K, std::vector<char>(3, 0), {}), std::invalid_argument);
  EXPECT_THROW(factor.analyze(plane.K, plane.fixed, {n}), std::invalid_argument);
  EXPECT_THROW(factor.analyze(plane.K, plane.fixed, {-1}), std::invalid_argument);
  EXPECT_THROW(factor.analyze(plane.K, plane.fixed, {4, 5, 4}), std::invalid_argument);
  EXPECT_THROW(factor.analyze(NodeBlockMatrix<2>(), {}, {}), std::invalid_argument);
  const std::vector<char> fixed(4, 0);
  const auto pattern = [](std::vector<int> row_start, std::vector<int> col) {
    return NodeBlockMatrix<2>{2, row_start, col, std::vector<double>(4 * col.size(), 0.)};
  };
  EXPECT_NO_THROW(SchurFactor<2>().analyze(pattern({0, 2, 4}, {0, 1, 0, 1}), fixed, {}));
  EXPECT_THROW(factor.analyze(pattern({0, 2, 3}, {0, 1, 1}), fixed, {}), std::invalid_argument); // one-sided
  EXPECT_THROW(factor.analyze(pattern({0, 2, 4}, {1, 0, 0, 1}), fixed, {}),
               std::invalid_argument);                                                        // unsorted
  EXPECT_THROW(factor.analyze(pattern({0, 1, 2}, {1, 0}), fixed, {}), std::invalid_argument); // no diagonal
  EXPECT_THROW(factor.analyze(pattern({0, 1, 2}, {0, 2}), fixed, {}), std::invalid_argument); // out of range
  EXPECT_THROW(factor.analyze(pattern({0, 1, 1}, {0, 1}), fixed, {}), std::invalid_argument); // too many
  EXPECT_THROW(factor.analyze(pattern({0, 3, 2}, {0, 1}), fixed, {}), std::invalid_argument); // descending
  EXPECT_EQ(factor.analyses(), 1);
  EXPECT_EQ(factor.solve(Eigen::VectorXd::Zero(plane.K.size())).norm(), 0.);
}
