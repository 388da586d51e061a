// Step lengths after failures: slow near the length that failed, free beyond it; times that end exactly.
#include "run/step_control.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

using namespace burnish;

namespace {

/// Long enough that its end does not matter.
StepControlOptions options() {
  StepControlOptions o;
  o.t_end = 1e9;
  o.dt_max = 1;
  o.dt_min = 1e-12;
  return o;
}

/// A step that was rejected `times` in a row, down to 2^-times of the largest, then accepted.
StepControl failed(int times) {
  StepControl control(0, options());
  for (int k = 0; k < 20; ++k) { // grown to the largest
    control.propose(0, 0);
    control.accepted();
  }
  control.propose(0, 0);
  for (int k = 0; k < times; ++k) EXPECT_TRUE(control.rejected());
  control.accepted();
  return control;
}

/// Accepted steps until one of at least `length` is proposed, that one not counted.
int steps_to(StepControl& control, double length) {
  int steps = 0;
  while (control.propose(0, 0) < length && steps < 1000) {
    control.accepted();
    ++steps;
  }
  return steps;
}

void expect_exact_end(double t_start, double t_end, const std::vector<double>& outputs) {
  SCOPED_TRACE("from " + std::to_string(t_start) + " to " + std::to_string(t_end));
  StepControlOptions o;
  o.t_end = t_end;
  o.output_times = outputs;
  StepControl control(t_start, o);
  std::vector<double> hits;
  std::mt19937 random(3);
  int steps = 0;
  for (; !control.finished() && steps < 5000; ++steps) {
    const double before = control.time();
    control.propose(0, 0);
    if (random() % 40 == 0) control.rejected();
    if (random() % 7 == 0) control.cut(1. / 3);
    control.accepted();
    ASSERT_GT(control.time(), before);
    if (control.at_output()) hits.push_back(control.time());
  }
  EXPECT_EQ(control.time(), t_end) << "to the last bit";
  std::vector<double> expected = outputs;
  if (outputs.empty() || outputs.back() != t_end) expected.push_back(t_end);
  EXPECT_EQ(hits, expected) << "to the last bit";
  EXPECT_LT(steps, 500);
}

} // namespace

// The cap is 0.7 of the failed length and grows by 5 % a step: it is past the failed length after the eighth one; then
// 1.3 a step. ln 1000/ln 1.3 = 26.3.
TEST(StepRecovery, AThousandTimesTheLengthThatFailed) {
  StepControl control = failed(20);
  const double length = std::ldexp(1., -19); // of the last one that failed
  EXPECT_DOUBLE_EQ(control.state().failed_dt, length);
  EXPECT_DOUBLE_EQ(control.state().last_dt, length / 2);
  EXPECT_EQ(steps_to(control, length), 7) << "one has been accepted already";
  EXPECT_EQ(control.state().failed_dt, 0) << "growth is free";
  EXPECT_EQ(steps_to(control, 1000 * length), 26);
}

TEST(StepRecovery, InAllFewerThan45Steps) {
  for (const int times : {11, 15, 25}) {
    StepControl control = failed(times);
    EXPECT_EQ(1 + steps_to(control, 1000 * std::ldexp(1., 1 - times)), 34) << times << " rejections";
  }
}

TEST(StepRecovery, NoJumpBackOverTheLengthThatFailed) {
  for (const int times : {1, 2, 6}) {
    StepControl control = failed(times);
    const double length = std::ldexp(1., 1 - times);
    double last = length / 2;
    for (int k = 1; k < 8; ++k) {
      const double dt = control.propose(0, 0);
      EXPECT_LE(dt, 0.7 * length * std::pow(1.05, k) * (1 + 1e-14)) << k;
      EXPECT_LT(dt, length) << k;
      EXPECT_LE(dt, 1.3 * last * (1 + 1e-14)) << k;
      EXPECT_GE(dt, last) << k;
      control.accepted();
      last = dt;
    }
  }
}

// All steps beyond one length fail: two in ten at most, from the length that failed last up to it again.
TEST(StepRecovery, FailuresAtOneLengthAreRare) {
  StepControl control(0, options());
  int accepted = 0, rejected = 0;
  while (accepted < 300) {
    bool failed = control.propose(0, 0) > 0.01;
    for (; failed; failed = control.dt() > 0.01) {
      ASSERT_TRUE(control.rejected());
      ++rejected;
    }
    control.accepted();
    ++accepted;
  }
  EXPECT_LE(rejected, 300 / 5);
}

TEST(StepRecovery, CrawlsWhileAFailureLimitsShortSteps) {
  StepControl control = failed(8);
  control.propose(0, 0);
  EXPECT_TRUE(control.crawls());
  while (control.state().failed_dt > 0) {
    EXPECT_TRUE(control.crawls());
    control.accepted();
    control.propose(0, 0);
  }
  EXPECT_FALSE(control.crawls()) << "short, but growing freely";
  EXPECT_LT(control.dt(), 0.02);
}

TEST(StepRecovery, ProgramsEndExactly) {
  expect_exact_end(0, 1, {});
  expect_exact_end(0, 0.3, {0.1, 0.1 + 0.1 / 3, 0.2999});
  expect_exact_end(2, 7, {2.5, 3, 7});
  expect_exact_end(0, 1e-9, {0.3e-9});
  expect_exact_end(0, 1e6 / 3, {1e5 / 3});
}

// The clock may begin before zero.
TEST(StepRecovery, ProgramsThatEndAtOrBeforeZero) {
  expect_exact_end(-1, 0, {-0.7, -0.1});
  expect_exact_end(-3, -1, {-2, -1.1});
  expect_exact_end(-1, 1, {0, 0.5});
}
