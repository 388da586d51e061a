#include "base/error.hpp"
#include "base/memory_limit.hpp"
#include "solver/schur_factor.hpp"
#include "unit/solver/elastic_sample.hpp"
#include <gtest/gtest.h>
#include <limits>

using namespace burnish;

TEST(SchurFactorRefusals, RefusesCallsOutOfOrder) {
  const sample::ClampedSector plane;
  SchurFactor<2> factor;
  EXPECT_THROW(factor.factorize(plane.K), std::invalid_argument);
  factor.analyze(plane.K, plane.fixed, plane.mesh.outer);
  EXPECT_THROW(factor.solve(Eigen::VectorXd::Zero(plane.K.size())), std::invalid_argument);
  EXPECT_THROW(factor.candidate_flexibility(), std::invalid_argument);
  EXPECT_THROW(factor.schur_complement(), std::invalid_argument);
  const NodeBlockMatrix<2> other = sample::stiffness(sample::ring_sector(2, 2), 1.);
  EXPECT_THROW(factor.factorize(other), std::invalid_argument);
  NodeBlockMatrix<2> truncated = plane.K;
  truncated.value.pop_back();
  EXPECT_THROW(factor.factorize(truncated), std::invalid_argument);
}

TEST(SchurFactorRefusals, RefusesNumbersThatAreNotFinite) {
  sample::ClampedSector plane;
  SchurFactor<2> factor;
  factor.analyze(plane.K, plane.fixed, plane.mesh.outer);
  ASSERT_EQ(factor.factorize(plane.K), FactorStatus::OK);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const int node = plane.mesh.outer[2], fixed_node = plane.mesh.inner[2];
  Eigen::VectorXd b = Eigen::VectorXd::Zero(plane.K.size());
  b[2 * fixed_node] = nan; // taken as zero
  EXPECT_EQ(factor.solve(b).norm(), 0.);
  b[2 * node + 1] = nan;
  EXPECT_THROW(factor.solve(b), std::invalid_argument);
  EXPECT_THROW(factor.solve(Eigen::VectorXd::Zero(3)), std::invalid_argument);
  plane.K.block(plane.K.find(node, node))[2] = nan;
  const std::string place = std::to_string(2 * node + 1) + ", column " + std::to_string(2 * node);
  try {
    factor.factorize(plane.K);
    FAIL() << "a NaN was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()),
              "SchurFactor::factorize: value of entry (row " + place + ") = nan, expected a finite number");
  }
}

// A chain of 500 000 nodes: 5 996 000 values, half of them 32 bytes each, where 80 MB are left.
TEST(SchurFactorRefusals, AMatrixThatCannotFitIsRefusedBeforeItIsOrdered) {
  const int n = 500000;
  NodeBlockMatrix<2> chain{n, {0}, {}, {}};
  for (int i = 0; i < n; ++i) {
    for (int j = std::max(0, i - 1); j <= std::min(n - 1, i + 1); ++j) chain.col.push_back(j);
    chain.row_start.push_back(static_cast<int>(chain.col.size()));
  }
  const std::vector<char> fixed(static_cast<std::size_t>(2 * n), 0);
  SchurFactor<2> factor;
  try {
    const MemoryLimit limit(80e6);
    factor.analyze(chain, fixed, {});
    FAIL() << "analyzed";
  } catch (const ArgumentError& e) {
    EXPECT_NE(e.said().find("the matrix of 1000000 unknowns and its factor take more than 0.10 GB"),
              std::string::npos)
        << e.what();
  }
}
