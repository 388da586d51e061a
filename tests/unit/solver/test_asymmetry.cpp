#include "solver/asymmetry.hpp"
#include "unit/solver/sparse_sample.hpp"
#include <gtest/gtest.h>

using namespace burnish;
using Pairs = std::vector<std::pair<int, int>>;

TEST(Asymmetry, PairsOfDifferingAndOneSidedEntries) {
  Eigen::MatrixXd full = Eigen::MatrixXd::Identity(4, 4);
  full(0, 1) = full(1, 0) = 0.5; // symmetric
  full(2, 1) = 0.5;
  full(1, 2) = 0.6; // differing
  full(0, 3) = 0.1; // above only
  full(3, 2) = 0.1; // below only
  const sample::Sparse matrix = sample::sparse(full);
  const SparsePattern pattern("test", matrix.view());
  Pairs pairs = asymmetric_pairs(pattern, matrix.view(), 1e-14);
  std::sort(pairs.begin(), pairs.end());
  EXPECT_EQ(pairs, (Pairs{{2, 1}, {3, 0}, {3, 2}}));
  pairs = asymmetric_pairs(pattern, matrix.view(), 0.15); // the differing pair and one-sided 0.1 pass
  EXPECT_EQ(pairs, Pairs());
  SparseView triangle = matrix.view();
  triangle.symmetric = true;
  EXPECT_EQ(asymmetric_pairs(pattern, triangle, 1e-14), Pairs());
}

TEST(Asymmetry, CoverTakesTheMostFrequentIndex) {
  EXPECT_EQ(greedy_cover(5, {}, 5), std::vector<int>());
  EXPECT_EQ(greedy_cover(6, {{5, 0}, {5, 1}, {5, 2}, {4, 3}}, 6), (std::vector<int>{3, 5}));
  EXPECT_EQ(greedy_cover(4, {{1, 0}, {2, 1}, {3, 2}}, 4), (std::vector<int>{1, 2})); // a path
  // two stars with a common edge: the second center counts without the edge taken with the first
  EXPECT_EQ(greedy_cover(8, {{6, 0}, {6, 1}, {6, 2}, {7, 6}, {7, 3}, {7, 4}}, 8), (std::vector<int>{6, 7}));
}

TEST(Asymmetry, CoverStopsAboveItsLimit) {
  Pairs pairs;
  for (int i = 0; i < 10; ++i) pairs.emplace_back(2 * i + 1, 2 * i);
  EXPECT_EQ(greedy_cover(20, pairs, 10).size(), 10u);
  EXPECT_EQ(greedy_cover(20, pairs, 4).size(), 5u);
}
