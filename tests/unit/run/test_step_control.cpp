// Step length: growth, contact width, halving and its cap, output times hit exactly, the rest split, the
// floor.
#include "run/step_control.hpp"
#include "unit/finite_difference.hpp"
#include <cmath>

using namespace burnish;
using namespace burnish::test;

namespace {

StepControlOptions options() {
  StepControlOptions o;
  o.t_end = 2;
  o.dt_max = 0.1;
  return o;
}

/// Takes n steps; returns the last length.
double advance(StepControl& control, int n, double width = 0, double speed = 0) {
  double dt = 0;
  for (int k = 0; k < n; ++k) {
    dt = control.propose(width, speed);
    control.accepted();
  }
  return dt;
}

} // namespace

TEST(StepControl, DefaultsAreSharesOfTheProgram) {
  StepControlOptions o;
  o.t_end = 5;
  StepControl control(1, o);
  EXPECT_DOUBLE_EQ(control.propose(0, 0), 0.04 / 4) << "a quarter of a hundredth of the program";
  for (int k = 0; k < 22; ++k) control.rejected();
  EXPECT_TRUE(control.dt() < 4e-7 && !control.rejected()) << "floor 1e-7 of the program";
}

TEST(StepControl, FirstStepQuarterThenGrowth) {
  StepControl control(0, options());
  EXPECT_DOUBLE_EQ(advance(control, 1), 0.025);
  EXPECT_DOUBLE_EQ(advance(control, 1), 0.0325);
  EXPECT_DOUBLE_EQ(advance(control, 1), 0.04225);
  EXPECT_DOUBLE_EQ(control.time(), 0.025 + 0.0325 + 0.04225);
  EXPECT_DOUBLE_EQ(advance(control, 8), 0.1) << "bounded by the largest step";
}

TEST(StepControl, LastStep) {
  StepControl control(0, options());
  int last = 0;
  for (int k = 0; k < 100 && !control.finished(); ++k) {
    control.propose(0, 0);
    last += control.is_last();
    EXPECT_EQ(control.is_last(), control.time() + control.dt() > 2 - 1e-9);
    control.accepted();
  }
  EXPECT_EQ(last, 1);
}

TEST(StepControl, FirstStepAsGiven) {
  StepControlOptions o = options();
  o.dt_first = 0.1;
  StepControl control(0, o);
  EXPECT_DOUBLE_EQ(advance(control, 1), 0.1);
  o.dt_max = 2;
  o.dt_first = 2;
  EXPECT_DOUBLE_EQ(StepControl(0, o).propose(0, 0), 2) << "the whole program";
}

TEST(StepControl, ContactWidthOverRollingSpeed) {
  StepControl control(0, options());
  advance(control, 8);
  EXPECT_DOUBLE_EQ(control.propose(2.8, 4), 2.8 / 14 / 4);
  EXPECT_DOUBLE_EQ(control.propose(5.6, 4), (0.75 * 2.8 + 0.25 * 5.6) / 14 / 4)
      << "the width counts by its running mean";
  for (int k = 0; k < 30; ++k) control.propose(0.28, 4);
  EXPECT_DOUBLE_EQ(control.propose(0.28, 4), 0.05) << "shrinks by half at most at a time";
  EXPECT_DOUBLE_EQ(control.propose(0, 4), 0.1) << "unknown width";
  EXPECT_DOUBLE_EQ(control.propose(2.8, 0), 0.1) << "unknown speed";
  StepControlOptions o = options();
  o.steps_per_width = 0;
  StepControl free(0, o);
  advance(free, 8);
  EXPECT_DOUBLE_EQ(free.propose(2.8, 4), 0.1);
}

TEST(StepControl, RejectedStepHalvesAndCaps) {
  StepControl control(0, options());
  advance(control, 8);
  EXPECT_DOUBLE_EQ(control.propose(0, 0), 0.1);
  EXPECT_TRUE(control.rejected());
  EXPECT_DOUBLE_EQ(control.dt(), 0.05);
  control.accepted();
  EXPECT_DOUBLE_EQ(advance(control, 1), 0.065) << "growth from the halved step";
  EXPECT_DOUBLE_EQ(advance(control, 1), 0.07 * 1.05 * 1.05) << "cap 0.7 of the failed step, 5 % a step";
  EXPECT_DOUBLE_EQ(advance(control, 1), 0.07 * std::pow(1.05, 3));
  EXPECT_DOUBLE_EQ(advance(control, 8), 0.1) << "the cap has relaxed";
}

TEST(StepControl, AccuracySteers) {
  StepControlOptions o = options();
  o.accuracy = 0.01;
  StepControl control(0, o);
  double dt = advance(control, 9);
  control.steer(0.02);
  EXPECT_DOUBLE_EQ(control.propose(0, 0), dt * std::pow(0.5, 0.4));
  control.accepted();
  dt = control.dt();
  control.steer(0.005); // geometric mean: 0.01, as asked
  EXPECT_DOUBLE_EQ(control.propose(0, 0), dt);
  control.accepted();
  control.steer(1);
  EXPECT_DOUBLE_EQ(control.propose(0, 0), 0.75 * dt) << "not shorter at a time";
  control.steer(0);
  EXPECT_DOUBLE_EQ(control.propose(0, 0), std::min(0.1, 1.3 * dt)) << "nothing flows";
}

TEST(StepControl, ProposalAfterRejectionStaysShort) {
  StepControl control(0, options());
  advance(control, 8);
  control.propose(0, 0);
  control.rejected();
  EXPECT_LE(control.propose(0, 0), 0.07);
}

TEST(StepControl, OutputTimesExactlyAndTheRestSplit) {
  StepControlOptions o = options();
  o.output_times = {0.3, 1.017, 2};
  StepControl control(0, o);
  std::vector<double> hits;
  double smallest = 1;
  while (!control.finished()) {
    smallest = std::min(smallest, control.propose(0, 0));
    control.accepted();
    if (control.at_output()) hits.push_back(control.time());
  }
  ASSERT_EQ(hits.size(), 3u);
  EXPECT_EQ(hits, o.output_times) << "to the last bit";
  EXPECT_GE(smallest, 0.012) << "no tiny steps before an output time";
}

TEST(StepControl, LessThanTwoStepsAreSplitEvenly) {
  StepControlOptions o = options();
  o.output_times = {0.045}; // first step 0.025, then 0.02 would be left
  StepControl control(0, o);
  EXPECT_DOUBLE_EQ(control.propose(0, 0), 0.0225);
  control.accepted();
  EXPECT_FALSE(control.at_output());
  EXPECT_NEAR(control.propose(0, 0), 0.0225, 1e-15);
  control.accepted();
  EXPECT_EQ(control.time(), 0.045);
  EXPECT_TRUE(control.at_output());
}

TEST(StepControl, FloorEndsTheRun) {
  StepControlOptions o = options();
  o.dt_min = 0.01;
  StepControl control(0, o);
  control.propose(0, 0);
  EXPECT_TRUE(control.rejected());
  EXPECT_FALSE(control.rejected()) << "0.00625 is below the floor";
}

TEST(StepControl, CutTakesAPart) {
  StepControl control(0, options());
  control.propose(0, 0);
  control.cut(0.4);
  control.accepted();
  EXPECT_DOUBLE_EQ(control.time(), 0.01);
  EXPECT_DOUBLE_EQ(control.propose(0, 0), 0.013);
}

TEST(StepControl, BadInput) {
  const auto with = [](auto change) {
    StepControlOptions o = options();
    change(o);
    StepControl(1, o);
  };
  expect_invalid([&] { with([](auto& o) { o.t_end = 1; }); },
                 "StepControl: t_end = 1, expected later than the start");
  expect_invalid([&] { with([](auto& o) { o.dt_min = 0.2; }); },
                 "StepControl: dt_min = 0.2, expected 0 < dt_min <= dt_max");
  expect_invalid([&] { with([](auto& o) { o.dt_first = 0.2; }); },
                 "StepControl: dt_first = 0.2, expected dt_min <= dt_first <= dt_max");
  expect_invalid([&] { with([](auto& o) { o.dt_max = -1; }); }, "expected 0 < dt_min <= dt_max");
  expect_invalid([&] { with([](auto& o) { o.steps_per_width = -1; }); },
                 "StepControl: steps_per_width = -1, expected >= 0");
}
