// A run goes on from a copy of its state, or its bytes, to the same bits, in every scheme, in itself and in another run;
// queries and an approach that fails change nothing.
#include "run/run_archive.hpp"
#include "support/rolling.hpp"
#include "unit/finite_difference.hpp"
#include "workpiece/point_fields.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// Coarse example 1 with its stepper; yields of points are events in event steps.
struct CoarseRun {
  Rolling rolling;
  Stepper<2> stepper;
  std::vector<double> history; ///< t, coordinates, forces after each step

  explicit CoarseRun(Scheme scheme, const IterationOptions& iteration = {})
      : rolling(12, 3, iteration),
        stepper(rolling.scene.contact(), rolling.scene.body, rolling.scene.diagnosis,
                Rolling::control(0.4, 0.05), options(scheme)) {}
  static StepperOptions options(Scheme scheme) {
    StepperOptions options;
    options.scheme = scheme;
    if (scheme != Scheme::IMPLICIT) options.events.elements = ElementEvents::CUT;
    return options;
  }
  void note() {
    history.push_back(stepper.control().time());
    for (const double q : rolling.scene.tool->q()) history.push_back(q);
    for (const double Q : rolling.scene.tool->generalized_force()) history.push_back(Q);
  }
  /// Goes on until a step ends beyond t_stop, or to the end. @returns the last task
  Task go(
      double t_stop, const std::function<void()>& on_task = [] {}) {
    for (;;) {
      const Task task = stepper.next(rolling.scene.u, rolling.scene.R);
      on_task();
      if (task == Task::RECORD) note();
      if (task == Task::FINISHED || task == Task::STOPPED) return task;
      if (task == Task::RECORD && stepper.control().time() > t_stop) return task;
      answer(task, rolling.scene, stepper, rolling.program());
    }
  }
  void set(const RunState<2>& state) { stepper.set_state(state, rolling.scene.u, rolling.scene.R); }
};

class EveryScheme : public testing::TestWithParam<Scheme> {};

void expect_same(CoarseRun& a, CoarseRun& b) {
  EXPECT_EQ(a.history, b.history);
  EXPECT_EQ(a.rolling.scene.u, b.rolling.scene.u);
  EXPECT_EQ(a.rolling.scene.R, b.rolling.scene.R);
  EXPECT_EQ(a.rolling.scene.workpiece().state().stress, b.rolling.scene.workpiece().state().stress);
  const auto &x = a.rolling.scene.contact().accepted(), &y = b.rolling.scene.contact().accepted();
  EXPECT_EQ(x.contact.q, y.contact.q);
  ASSERT_EQ(x.log.events.size(), y.log.events.size());
  for (std::size_t k = 0; k < x.log.events.size(); ++k) EXPECT_EQ(x.log.events[k].t, y.log.events[k].t);
  EXPECT_EQ(a.stepper.counts().steps, b.stepper.counts().steps);
  EXPECT_EQ(a.stepper.counts().rejected, b.stepper.counts().rejected);
}

} // namespace

TEST_P(EveryScheme, GoesOnFromACopyToTheSameBits) {
  CoarseRun whole(GetParam()), other(GetParam());
  ASSERT_EQ(whole.go(0.15), Task::RECORD);
  const RunState<2> state = whole.stepper.state();
  const std::vector<double> before = whole.history;
  ASSERT_EQ(whole.go(1), Task::FINISHED) << whole.stepper.reason();
  EXPECT_GT(whole.history.size(), before.size() + 7);

  other.set(state); // a run that has not begun
  other.history = before;
  ASSERT_EQ(other.go(1), Task::FINISHED) << other.stepper.reason();
  expect_same(whole, other);

  CoarseRun again(GetParam()); // a run that has gone another way
  again.go(0.3);
  again.set(state);
  again.history = before;
  ASSERT_EQ(again.go(1), Task::FINISHED) << again.stepper.reason();
  expect_same(whole, again);
}

// All of it but CPU seconds and analyses, which a factor that is made again needs anew.
std::string essence(const CoarseRun& run) {
  RunState<2> state = run.stepper.state();
  state.contact.counts = {};
  state.diagnosis = {};
  return packed(state);
}
void go_on_from_bytes(CoarseRun& whole, CoarseRun& other) {
  ASSERT_EQ(whole.go(0.15), Task::RECORD);
  const std::string bytes = packed(whole.stepper.state());
  const std::vector<double> before = whole.history;
  ASSERT_EQ(whole.go(1), Task::FINISHED) << whole.stepper.reason();
  const RunState<2> state = unpacked<2>(bytes);
  EXPECT_EQ(packed(state), bytes);
  other.set(state);
  other.history = before;
  ASSERT_EQ(other.go(1), Task::FINISHED) << other.stepper.reason();
  expect_same(whole, other);
  EXPECT_EQ(essence(whole), essence(other));
  const auto said = whole.stepper.report(), again = other.stepper.report();
  ASSERT_EQ(said.size(), again.size());
  for (std::size_t k = 0; k < said.size(); ++k) EXPECT_EQ(said[k].text, again[k].text);
}

TEST_P(EveryScheme, GoesOnFromItsBytesToTheSameBits) {
  CoarseRun whole(GetParam()), other(GetParam());
  go_on_from_bytes(whole, other);
}

TEST(RunBytes, OfAFactorThatServesSeveralSteps) {
  IterationOptions options;
  options.steps_per_factor = 4;
  CoarseRun whole(Scheme::IMPLICIT, options), other(Scheme::IMPLICIT, options);
  go_on_from_bytes(whole, other);
}

TEST(RunBytes, OfNoRun) {
  CoarseRun run(Scheme::IMPLICIT);
  run.go(0.05);
  const std::string bytes = packed(run.stepper.state());
  EXPECT_THROW(unpacked<2>(bytes.substr(0, bytes.size() / 2)), std::invalid_argument);
  EXPECT_THROW(unpacked<3>(bytes), std::invalid_argument);
  EXPECT_THROW(unpacked<2>(""), std::invalid_argument);
}

TEST_P(EveryScheme, QueriesChangeNothing) {
  CoarseRun plain(GetParam()), asked(GetParam());
  ASSERT_EQ(plain.go(1), Task::FINISHED) << plain.stepper.reason();
  auto& contact = asked.rolling.scene.contact();
  ASSERT_EQ(asked.go(1,
                     [&] {
                       asked.stepper.state();
                       contact.state();
                       asked.rolling.scene.why();
                       left_out(contact);
                       contact_width(contact);
                       contact_speed(contact);
                       asked.rolling.scene.body.state();
                       largest_yield_distance(asked.rolling.scene.body.workpiece());
                     }),
            Task::FINISHED);
  expect_same(plain, asked);
}

INSTANTIATE_TEST_SUITE_P(RunState, EveryScheme,
                         testing::Values(Scheme::IMPLICIT, Scheme::EVENT, Scheme::ARTICLE));

TEST(RunStateErrors, OfAnotherRun) {
  CoarseRun run(Scheme::IMPLICIT);
  RunState<2> state = run.stepper.state();
  state.contact.contact.nodes.pop_back();
  EXPECT_THROW(run.set(state), std::invalid_argument);
  EXPECT_EQ(run.go(1), Task::FINISHED) << "nothing has changed";
}

TEST(RunState, FailedApproachLeavesAllAsItWas) {
  Rolling rolling(12, 3);
  auto& contact = rolling.scene.contact();
  rolling.scene.place({60e-3, M_PI / 2, 0}); // away, and turning brings it no nearer
  const Eigen::VectorXd placed = rolling.scene.tool->q();
  const ContactRunState<2> before = contact.state();
  EXPECT_THROW(contact.approach(0, "theta", rolling.scene.u), std::invalid_argument);
  const ContactRunState<2> after = contact.state();
  EXPECT_EQ(before.contact.q, after.contact.q);
  EXPECT_EQ(rolling.scene.tool->q(), placed);
  for (std::size_t i = 0; i < before.contact.nodes.size(); ++i)
    EXPECT_EQ(before.contact.nodes[i].state, after.contact.nodes[i].state);
}
