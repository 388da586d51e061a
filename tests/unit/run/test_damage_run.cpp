// Steps of a run with damage: a copy of the state goes on to the same bits, rejected steps restore the integrities, pieces
// of event steps count by their share.
#include "run/run_archive.hpp"
#include "support/run.hpp"
#include "workpiece/healing.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// Block 4 x 1.5 pressed by a roller; points crumble at a plastic strain.
struct Crumbling : Scene {
  double y_touch = 0;
  Stepper<2> stepper;
  explicit Crumbling(Scheme scheme)
      : Scene(block_mesh(8, 3, 2, 4, 1.5), J2Parameters::from_shear(1, 0.3, 0.01, 0.1)),
        stepper(ready(), body, diagnosis, StepControl(0, control()), options(scheme)) {
    body.user().add(workpiece(), "crumble", "ep - 0.004");
    body.damage().damage(workpiece(), body.user(), "crumble", 0.2, 4);
  }
  ContactRun<2>& ready() {
    add_tool(std::make_shared<Circle>(3.), std::make_shared<Cartesian>(), 0.3);
    place({1.9, 4.9, 0});
    contact().approach(0, "y", u);
    y_touch = tool->q()[1];
    return contact();
  }
  static StepControlOptions control() {
    StepControlOptions control;
    control.dt_max = 0.05;
    return control;
  }
  static StepperOptions options(Scheme scheme) {
    StepperOptions options;
    options.scheme = scheme;
    if (scheme == Scheme::EVENT) options.events.elements = ElementEvents::CUT;
    return options;
  }
  /// Goes on until a step ends beyond t_stop, or to the end. @param refuse_from equilibria of steps that end
  /// beyond this instant are refused until one step is rejected
  Task go(double t_stop, double refuse_from = 2) {
    const ProgramAt program = [&](double t) {
      tool->prescription().move("x", 1.9);
      tool->prescription().move("angle", 0);
      tool->prescription().move("y", y_touch - 0.06 * t);
    };
    const long rejected = stepper.counts().rejected;
    for (;;) {
      const Task task = stepper.next(u, R);
      if (task == Task::FINISHED || task == Task::STOPPED) return task;
      if (task == Task::RECORD && stepper.control().time() > t_stop) return task;
      if (task == Task::FORCES && stepper.target() > refuse_from && stepper.counts().rejected == rejected) {
        stepper.refuse("by the test");
        continue;
      }
      answer(task, *this, stepper, program);
    }
  }
  double lowest() {
    const auto& w = workpiece().state_old().integrity;
    return *std::min_element(w.begin(), w.end());
  }
};

class DamageRun : public testing::TestWithParam<Scheme> {};

} // namespace

TEST_P(DamageRun, ACopyGoesOnToTheSameBits) {
  Crumbling first(GetParam()), second(GetParam());
  ASSERT_EQ(first.go(0.4), Task::RECORD);
  ASSERT_LT(first.lowest(), 1);
  const RunState<2> saved = first.stepper.state();
  double changing = 0;
  for (const double rate : saved.body.workpiece.integrity_rate) changing += rate != 0;
  EXPECT_GT(changing, 0) << "saved in the middle of changes";
  second.stepper.set_state(unpacked<2>(packed(saved)), second.u, second.R);
  for (Crumbling* run : {&first, &second}) ASSERT_EQ(run->go(0.7), Task::RECORD);
  EXPECT_GT(heal_all(first.workpiece(), 3), 0);
  EXPECT_GT(heal_all(second.workpiece(), 3), 0);
  for (Crumbling* run : {&first, &second}) ASSERT_EQ(run->go(1), Task::FINISHED);
  EXPECT_EQ(first.u, second.u);
  EXPECT_EQ(first.workpiece().state().integrity, second.workpiece().state().integrity);
  EXPECT_EQ(first.workpiece().state().stress, second.workpiece().state().stress);
  EXPECT_EQ(first.tool->generalized_force(), second.tool->generalized_force());
  EXPECT_GT(first.body.user().number("crumble"), 0);
}

TEST_P(DamageRun, ARejectedStepRestoresTheIntegrities) {
  Crumbling run(GetParam());
  ASSERT_EQ(run.go(0.4), Task::RECORD);
  const WorkpieceState<2> before = run.workpiece().state_old();
  const long rejected = run.stepper.counts().rejected;
  ASSERT_EQ(run.go(0.401, 0.4), Task::RECORD);
  EXPECT_EQ(run.stepper.counts().rejected, rejected + 1);
  const WorkpieceState<2>& after = run.workpiece().state_old();
  int halves = 0; // tried again with half the length: half of the change
  for (std::size_t p = 0; p < before.integrity.size(); ++p) {
    if (before.integrity_rate[p] == 0) continue;
    const double goal = before.integrity_goal[p], half = before.integrity[p] + 0.5 * before.integrity_rate[p];
    EXPECT_NEAR(after.integrity[p], std::max(goal, half), 1e-12);
    ++halves;
  }
  EXPECT_GT(halves, 0);
}

INSTANTIATE_TEST_SUITE_P(Schemes, DamageRun, testing::Values(Scheme::IMPLICIT, Scheme::EVENT));
