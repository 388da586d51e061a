// Order of the nodes of boundary edges.
#include "mesh/mesh.hpp"
#include <gtest/gtest.h>

using namespace burnish;

TEST(NodesAlong, OpenChainFromItsEnd) {
  EXPECT_EQ(nodes_along<2>({{{7, 3}, {-1}, -1, 0}, {{9, 7}, {-1}, -1, 0}, {{3, 5}, {-1}, -1, 0}}),
            (std::vector<int>{5, 3, 7, 9}));
  EXPECT_EQ(nodes_along<2>({{{7, 3}, {20}, -1, 0}, {{9, 7}, {21}, -1, 0}, {{3, 5}, {22}, -1, 0}}),
            (std::vector<int>{5, 22, 3, 20, 7, 21, 9}));
}

TEST(NodesAlong, ClosedChainAndTwoChains) {
  EXPECT_EQ(nodes_along<2>({{{0, 1}, {-1}, -1, 0}, {{2, 0}, {-1}, -1, 0}, {{1, 2}, {-1}, -1, 0}}).size(), 3u);
  const auto two = nodes_along<2>(
      {{{10, 11}, {-1}, -1, 0}, {{1, 2}, {-1}, -1, 0}, {{11, 12}, {-1}, -1, 0}, {{2, 3}, {-1}, -1, 0}});
  EXPECT_EQ(two, (std::vector<int>{1, 2, 3, 10, 11, 12}));
  EXPECT_TRUE(nodes_along<2>({}).empty());
}
