// The state of a workpiece as one value: accept and revert, copies, names, bad input.
#include "unit/material/j2/point_walk.hpp"
#include "unit/workpiece/patch.hpp"
#include "workpiece/point_events.hpp"
#include "workpiece/point_fields.hpp"
#include <limits>

using namespace burnish;
using namespace burnish::test;

namespace {

const double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();

Workpiece<2> workpiece(int nodes = 3, UpdateOptions options = {}) {
  return {patch(nodes, 1), j2_law<2>(example_material()), options};
}

UpdateOptions with_update(StressUpdate update) {
  UpdateOptions options;
  options.update = update;
  return options;
}

} // namespace

TEST(WorkpieceState, AcceptAndRevert) {
  Workpiece<2> body = workpiece(6);
  const WorkpieceState<2> start = body.state();
  body.update(bent(body.discretization(), 1, 0.005), 1, 0);
  const WorkpieceState<2> end = body.state();
  EXPECT_TRUE(same(body.state_old(), start));
  body.revert();
  EXPECT_TRUE(same(body.state(), start));
  body.update(bent(body.discretization(), 1, 0.005), 1, 0);
  body.accept();
  EXPECT_TRUE(same(body.state_old(), end));
  EXPECT_TRUE(same(body.state(), end));
  Workpiece<2> restarted = workpiece(6);
  restarted.set_state(end);
  for (Workpiece<2>* w : {&body, &restarted}) w->update(bent(w->discretization(), 1, 0.008), 0.7, 0);
  EXPECT_TRUE(same(body.state(), restarted.state())); // restart to the last bit
}

// The state is all that is needed to go on: iterations with growing and frozen substeps, tangents, events, acceptance.
TEST(WorkpieceState, ACopyOfTheStateGoesOnToTheSameBits) {
  for (StressUpdate update : {StressUpdate::SUBSTEPPED, StressUpdate::SINGLE, StressUpdate::FORWARD_EULER}) {
    Workpiece<2> first = workpiece(6, with_update(update));
    const auto tangent_of = [](const Workpiece<2>& body) {
      NodeBlockMatrix<2> K = body.pattern();
      body.tangent(K, TangentKind::CONSISTENT, 0.2);
      return K.value;
    };
    const auto target = [&](int step, int iteration) {
      return Eigen::VectorXd((0.004 * step + 5e-4 * iteration) * bent(first.discretization(), 1, 1));
    };
    const auto run = [&](Workpiece<2>& body, int from, int to) {
      for (int step = from; step < to; ++step) {
        for (int iteration = 0; iteration < 6; ++iteration)
          body.update(target(step, iteration), 1 + step, iteration);
        body.accept();
        accept_events(element_events<2>(body, 1e-3), body);
      }
    };
    run(first, 1, 4);
    first.update(target(9, 0), 1, 0); // a step that is given up leaves nothing behind
    first.revert();
    const WorkpieceState<2> copy = first.state_old();
    Workpiece<2> second = workpiece(6, with_update(update));
    second.set_state(copy);
    EXPECT_EQ(tangent_of(first), tangent_of(second));
    EXPECT_EQ(first.internal_force(), second.internal_force());
    for (Workpiece<2>* body : {&first, &second}) run(*body, 4, 7);
    EXPECT_TRUE(same(first.state(), second.state()));
    EXPECT_TRUE(same(first.state_old(), second.state_old()));
    for (Workpiece<2>* body : {&first, &second}) body->update(target(8, 0), 2, 0);
    EXPECT_EQ(tangent_of(first), tangent_of(second));
    EXPECT_GT(internal_field(first, "plastic_strain_eq").maxCoeff(), 0.02);
  }
}

TEST(WorkpieceState, QueriesChangeNothing) {
  Workpiece<2> body = workpiece(6);
  body.update(bent(body.discretization(), 1, 0.01), 1, 0);
  const WorkpieceState<2> now = body.state(), old = body.state_old();
  NodeBlockMatrix<2> K = body.pattern();
  body.tangent(K, TangentKind::RATE);
  body.internal_force();
  element_events<2>(body, 0.1);
  PointEvents<2> events;
  events.add(body, "stressed", "seq - 1e8");
  const PointEventsState counted = events.state();
  events.find(body);
  events.earliest(body, 0);
  EXPECT_TRUE(same(body.state(), now));
  EXPECT_TRUE(same(body.state_old(), old));
  EXPECT_EQ(events.state()[0].above, counted[0].above);
  EXPECT_EQ(events.state()[0].count, counted[0].count);
}

TEST(WorkpieceState, InternalVariablesByName) {
  Workpiece<2> body = workpiece(6);
  body.update(bent(body.discretization(), 1, 0.01), 1, 0);
  const Eigen::VectorXd plastic_strain_eq = internal_field(body, "plastic_strain_eq");
  ASSERT_EQ(plastic_strain_eq.size(), 24);
  for (int p = 0; p < 24; ++p) EXPECT_EQ(plastic_strain_eq[p], plastic_strain_eq_at(body.state(), p));
  EXPECT_EQ(body.law().internal_variables().list()[0].unit, "-");
  expect_invalid([&] { internal_field(body, "damage"); },
                 "internal_field: law \"J2\" has no internal variable \"damage\", expected one of "
                 "plastic_strain_eq");
}

TEST(WorkpieceState, ErrorsOfSetState) {
  Workpiece<2> body = workpiece();
  const WorkpieceState<2> good = body.state();
  const auto expect_state = [&](auto change, const std::string& text) {
    WorkpieceState<2> state = good;
    change(state);
    expect_invalid([&] { body.set_state(state); }, "Workpiece::set_state: " + text);
    EXPECT_TRUE(same(body.state(), good));
  };
  expect_state([](auto& s) { s.displacement.resize(3); }, "size of displacement = 3, expected 18");
  expect_state([](auto& s) { s.F.pop_back(); }, "size of F = 39, expected 40");
  expect_state([](auto& s) { s.stress.pop_back(); }, "size of stress = 31, expected 32");
  expect_state([](auto& s) { s.strain_increment.pop_back(); }, "size of strain_increment = 31, expected 32");
  expect_state([](auto& s) { s.internal.pop_back(); }, "size of internal = 7, expected 8");
  expect_state([](auto& s) { s.plastic.pop_back(); }, "size of plastic = 7, expected 8");
  expect_state([](auto& s) { s.stress[5] = NOT_A_NUMBER; }, "stress = nan, expected finite numbers");
  expect_state([](auto& s) { s.displacement[5] = NOT_A_NUMBER; },
               "displacement = nan, expected finite numbers");
  expect_state([](auto& s) { s.F[5] = -1; }, "det F = -1, expected > 0");
  expect_state([](auto& s) { s.F[4] = -2; }, "det F = -2, expected > 0");
  expect_state([](auto& s) { s.F[0] = s.F[4] = -2; }, "det F = -4, expected > 0"); // turned over twice
  expect_state([](auto& s) { s.dt = -1; }, "dt = -1, expected finite >= 0");
}
