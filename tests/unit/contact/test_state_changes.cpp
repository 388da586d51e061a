// What events do to states, and the record of changes between two accepted states.
#include "unit/contact/event_scene.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

ContactEvent<2> event_at(EventKind kind, int candidate, const Vector<2>& direction = Vector<2>::Zero()) {
  ContactEvent<2> event;
  event.kind = kind;
  event.candidate = event.node = candidate;
  event.slip_direction = direction;
  return event;
}

void expect_node(const ContactNode<2>& node, NodeState state, double s,
                 const Vector<2>& direction = Vector<2>::Zero()) {
  EXPECT_STREQ(name_of(node.state), name_of(state));
  EXPECT_NEAR(node.place.hint[0], s, 1e-13);
  EXPECT_NEAR(node.place.y[0], 20 - s, 1e-13);
  EXPECT_EQ(node.slip_origin.hint, node.place.hint);
  EXPECT_EQ(node.slip_origin.y, node.place.y);
  EXPECT_EQ(node.slip_direction, direction);
  EXPECT_EQ(node.slip_rate, 0);
}

} // namespace

TEST(ApplyEvents, EachKind) {
  EventScene scene;
  scene.add_plate(0, 0.3);
  scene.touch(1, NodeState::SLIDING, 1);
  scene.touch(2, NodeState::SLIDING, -1);
  scene.touch(3, NodeState::STICKING, 0);
  for (int i : {1, 2, 3}) {
    scene.start.nodes[i].slip_origin =
        place_of(*scene.model.tools[0], EventScene::s(scene.start.nodes[i]) - 0.1);
    scene.start.nodes[i].slip_rate = 3;
  }
  apply_events<2>(scene.model, scene.body,
                  {event_at(EventKind::TOUCH, 0), event_at(EventKind::RELEASE, 1),
                   event_at(EventKind::SLIP_TO_STICK, 2),
                   event_at(EventKind::STICK_TO_SLIP, 3, Vector<2>(1, 0)), event_at(EventKind::YIELD, -1)},
                  scene.u0, scene.start);
  expect_node(scene.start.nodes[0], NodeState::TOUCHED, 20);
  EXPECT_EQ(scene.start.nodes[0].tool, 0);
  expect_node(scene.start.nodes[1], NodeState::LEAVING, 19);
  expect_node(scene.start.nodes[2], NodeState::STICKING, 18);
  expect_node(scene.start.nodes[3], NodeState::SLIDING, 17, Vector<2>(1, 0));
  EXPECT_EQ(scene.start.nodes[4].state, NodeState::FREE);
}

TEST(ApplyEvents, TouchWithoutFrictionSlides) {
  EventScene scene;
  scene.add_plate(0, 0);
  apply_events<2>(scene.model, scene.body, {event_at(EventKind::TOUCH, 5)}, scene.u0, scene.start);
  expect_node(scene.start.nodes[5], NodeState::SLIDING, 15);
}

// LEAVING takes its rest reaction off in one step; then the node recedes until its gap has opened, or, if it
// comes back, is free to touch again.
TEST(SettleReleased, LeavingRecedingFree) {
  EventScene scene;
  scene.add_plate(0, 0.3);
  scene.start.nodes[0].state = scene.start.nodes[1].state = NodeState::LEAVING;
  scene.start.nodes[2].state = scene.start.nodes[3].state = NodeState::RECEDING;
  scene.start.nodes[4].state = NodeState::STICKING;
  scene.u0[3] = -0.02;  // node 1 is open
  scene.u0[5] = -0.005; // node 2 within the tolerance
  scene.u0[7] = 0.02;   // node 3 inside
  scene.u0[9] = -0.5;   // node 4 does not matter
  settle_released(scene.model, scene.body, scene.u0, 0.01, scene.start);
  const NodeState expected[] = {NodeState::RECEDING, NodeState::FREE,     NodeState::RECEDING,
                                NodeState::FREE,     NodeState::STICKING, NodeState::FREE};
  for (int i = 0; i < 6; ++i) EXPECT_STREQ(name_of(scene.start.nodes[i].state), name_of(expected[i])) << i;
}

TEST(StateChanges, EveryChangeOnce) {
  EventScene scene;
  scene.add_plate(0, 0.3);
  scene.touch(1, NodeState::SLIDING, 1);
  scene.touch(2, NodeState::SLIDING, 1);
  scene.touch(3, NodeState::STICKING, 0);
  scene.touch(4, NodeState::STICKING, 0);
  EventScene::set_force(scene.R0, 1, 1, 0);
  scene.end.nodes[0] = scene.end.nodes[4]; // touches
  scene.end.nodes[1] = {};                 // leaves
  scene.end.nodes[2].state = NodeState::STICKING;
  scene.end.nodes[3].state = NodeState::SLIDING;
  scene.u0[1] = -0.2;
  const auto changes = state_changes(scene.model, scene.body, scene.step());
  const EventKind kinds[] = {EventKind::TOUCH, EventKind::RELEASE, EventKind::SLIP_TO_STICK,
                             EventKind::STICK_TO_SLIP};
  ASSERT_EQ(changes.size(), 4u);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(changes[i].node, i);
    EXPECT_STREQ(name_of(changes[i].kind), name_of(kinds[i]));
    EXPECT_EQ(changes[i].tool, 0);
    EXPECT_GE(changes[i].fraction, 0);
    EXPECT_LE(changes[i].fraction, 1);
    EXPECT_DOUBLE_EQ(changes[i].t, 10 + 2 * changes[i].fraction);
  }
}
