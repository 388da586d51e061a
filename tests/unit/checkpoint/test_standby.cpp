// Which states of a run are kept in memory: the first, then those whose making is a small part of what has passed.
#include "checkpoint/standby.hpp"
#include <gtest/gtest.h>

using namespace burnish;

TEST(Standby, NextOneIsDueAfterTwoHundredTimesItsCost) {
  StandbyCheckpoint standby;
  EXPECT_TRUE(standby.due(0));
  EXPECT_EQ(standby.get(), nullptr);
  Checkpoint checkpoint;
  checkpoint.t = 0.25;
  standby.keep(checkpoint, 10, 0.01);
  ASSERT_NE(standby.get(), nullptr);
  EXPECT_EQ(standby.get()->t, 0.25);
  EXPECT_FALSE(standby.due(11.9));
  EXPECT_TRUE(standby.due(12.1));
}

TEST(Standby, ClearedItHoldsNoneAndKeepsItsTime) {
  StandbyCheckpoint standby;
  standby.keep(Checkpoint(), 10, 0.01);
  standby.clear();
  EXPECT_EQ(standby.get(), nullptr);
  EXPECT_FALSE(standby.due(11));
  EXPECT_TRUE(standby.due(13));
}
