// Numbers in a factor by the graph alone.
#include "solver/fill_ordering.hpp"
#include <gtest/gtest.h>

using namespace burnish;

// A chain has a number a vertex and a link in any good order; a star too, with its middle last; a ring all but three a third one.
TEST(FillOrdering, FactorOfChainStarAndRing) {
  Graph chain, star, ring;
  constexpr int N = 20;
  for (int i = 0; i < N; ++i) {
    chain.col.push_back(i > 0 ? i - 1 : i);
    star.col.push_back(0);
    ring.col.push_back((i + 1) % N);
    for (Graph* one : {&chain, &star, &ring}) one->row_start.push_back(static_cast<int>(one->col.size()));
  }
  EXPECT_EQ(factor_fill(chain, Ordering::AMD), 2 * N - 1);
  EXPECT_EQ(factor_fill(star, Ordering::AMD), 2 * N - 1);
  EXPECT_EQ(factor_fill(ring, Ordering::AMD), 3 * N - 3);
  EXPECT_GE(factor_fill(ring, Ordering::METIS), 3 * N - 3); // from halves: some more
  EXPECT_LE(factor_fill(ring, Ordering::METIS), 4 * N);
  EXPECT_EQ(factor_fill(Graph(), Ordering::AMD), 0);
}
