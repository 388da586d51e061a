// Where events are located: earliest fraction, events taken together, touch on the true gap, release, stick
// and slip, events at once.
#include "unit/contact/event_scene.hpp"

using namespace burnish;
using namespace burnish::test;

TEST(Events, NamesOfKindsAndStates) {
  const char* kinds[] = {"touch", "release", "slip-to-stick", "stick-to-slip", "next-piece",
                         "jump",  "yield",   "unloading",     "user"};
  for (int k = 0; k < 9; ++k) EXPECT_STREQ(name_of(static_cast<EventKind>(k)), kinds[k]);
  const char* states[] = {"free", "touched", "sliding", "sticking", "leaving", "receding"};
  for (int k = 0; k < 6; ++k) EXPECT_STREQ(name_of(static_cast<NodeState>(k)), states[k]);
}

// Gaps 0.1, 0.2, .. and the plate comes down by 0.4: the first node meets it after a quarter of the step.
TEST(Events, EarliestTouchOnly) {
  EventScene scene;
  for (int i = 0; i < 6; ++i) scene.u0[2 * i + 1] = scene.u1[2 * i + 1] = -0.1 * i;
  scene.u1[0] = 0.2; // and it moves sideways
  scene.add_plate(0.1, 0.3);
  scene.end.q[1] = -0.3;
  const auto event = scene.single(EventKind::TOUCH, 0, 0.25);
  EXPECT_NEAR(event.x[0], 0.05, 1e-12);
  EXPECT_NEAR(event.x[1], 0, 1e-12);
}

TEST(Events, NothingHappens) {
  EventScene scene;
  scene.add_plate(0.1, 0.3);
  scene.end.q[1] = 0.05;
  EXPECT_TRUE(scene.earliest().empty());
}

// Fractions 0.25, 0.25, 0.2504 and 0.26 with a tolerance of 1e-3: the first three are one event.
TEST(Events, SimultaneousOnesTogether) {
  EventScene scene;
  const double gaps[] = {0.2504, 0.25, 0.26, 0.25, 0.9, 0.8};
  for (int i = 0; i < 6; ++i) scene.u0[2 * i + 1] = scene.u1[2 * i + 1] = -gaps[i];
  scene.add_plate(0, 0.3);
  scene.end.q[1] = -1;
  std::vector<int> nodes;
  for (const auto& event : scene.earliest()) nodes.push_back(event.node);
  EXPECT_EQ(nodes, (std::vector<int>{0, 1, 3}));
  scene.tolerance.fraction = 0.02;
  EXPECT_EQ(scene.earliest().size(), 4u);
}

// A roller passes a node sideways: the gap is far from linear in the fraction.
TEST(Events, TouchRefinedOnTheTrueGap) {
  EventScene scene;
  scene.add(std::make_shared<Circle>(1.), Vector<3>(-2, 0.8, 0), 0.3);
  scene.end.q << -0.5, 0.8, 0; // touches node 0 where (x - x_node)^2 + 0.8^2 = 1, x = -0.6
  const double exact = 1.4 / 1.5, start = std::hypot(2, 0.8) - 1, end = std::hypot(0.5, 0.8) - 1;
  scene.single(EventKind::TOUCH, 0, exact, 1e-6);
  EXPECT_GE(std::abs(start / (start - end) - exact), 0.01) << "linear interpolation would miss it";
}

TEST(Events, TouchAtTheEndsOfTheStep) {
  EventScene scene;
  scene.u0[1] = scene.u1[1] = -0.5;
  for (int i = 1; i < 6; ++i) scene.u0[2 * i + 1] = scene.u1[2 * i + 1] = -2;
  scene.add_plate(0, 0.3);
  scene.end.q[1] = -0.5 + 0.5e-6; // within the tolerance at the end
  scene.single(EventKind::TOUCH, 0, 1);
  scene.start.q[1] = -0.5 - 1e-9; // a rounding inside from the start, and deeper
  scene.end.q[1] = -0.6;
  scene.single(EventKind::TOUCH, 0, 0);
}

TEST(Events, NearestToolIsNamed) {
  EventScene scene;
  scene.add_plate(5, 0.3);
  scene.add(std::make_shared<Circle>(1.), Vector<3>(2, 1.5, 0), 0.3);
  scene.end.q.tail<3>() << 2, 0.5, 0;
  EXPECT_EQ(scene.single(EventKind::TOUCH, 2, 0.5).x[0], 2);
}

TEST(Events, ReleaseWherePressureVanishes) {
  for (const double mu : {0., 0.3}) {
    EventScene scene;
    scene.add_plate(0, mu);
    scene.touch(2, NodeState::SLIDING, mu > 0 ? 1 : 0);
    scene.slip(scene.end.nodes[2], 0.1); // goes on sliding
    EventScene::set_force(scene.R0, 2, 2, -2 * mu);
    EventScene::set_force(scene.R1, 2, -1, mu);
    scene.single(EventKind::RELEASE, 2, 2. / 3);
    EventScene::set_force(scene.R0, 2, -1e-3, 0); // below zero from the start
    scene.single(EventKind::RELEASE, 2, 0);
    EventScene::set_force(scene.R1, 2, 1, 0);
    EXPECT_TRUE(scene.earliest().empty()) << "pressure comes back";
  }
}

// Friction limit 0.3 N against T: crossing where both are linear in the fraction.
TEST(Events, StickToSlipWhereFrictionIsExhausted) {
  for (const double side : {1., -1.}) {
    for (const NodeState held : {NodeState::STICKING, NodeState::TOUCHED}) {
      EventScene scene;
      scene.add_plate(0, 0.3);
      scene.touch(1, held, 0);
      EventScene::set_force(scene.R0, 1, 2, 0.2 * side); // limit 0.6
      EventScene::set_force(scene.R1, 1, 1, 0.6 * side); // limit 0.3
      const auto event = scene.single(EventKind::STICK_TO_SLIP, 1, 0.4 / 0.7);
      EXPECT_LE((event.slip_direction - Vector<2>(side, 0)).norm(), 1e-15) << "friction opposes slip";
    }
  }
}

// A sticking node never leaves directly: it slides at the instant at which it cannot hold any more, which
// comes before its pressure vanishes unless it bears no shear.
TEST(Events, StickingNodeSlidesBeforeItLeaves) {
  EventScene scene;
  scene.add_plate(0, 0.3);
  scene.touch(1, NodeState::STICKING, 0);
  EventScene::set_force(scene.R0, 1, 2, 0);
  EventScene::set_force(scene.R1, 1, -1, 0);
  scene.single(EventKind::STICK_TO_SLIP, 1, 2. / 3);
  EventScene::set_force(scene.R0, 1, 2, 0.1);
  EventScene::set_force(scene.R1, 1, -1, 0.1); // 0.3 N = 0.1 at N = 1/3
  scene.single(EventKind::STICK_TO_SLIP, 1, 5. / 9);
}

// The rates of slip are means of steps: 1 in the middle of the last one (as long as this one), -0.5 in the
// middle of this one; zero in between.
TEST(Events, SlipToStickWhereTheSlipTurns) {
  for (const double side : {1., -1.}) {
    EventScene scene;
    scene.add_plate(0, 0.3);
    scene.touch(3, NodeState::SLIDING, side);
    for (Eigen::VectorXd* R : {&scene.R0, &scene.R1}) EventScene::set_force(*R, 3, 1, -0.3 * side);
    scene.start.nodes[3].slip_rate = 1;
    scene.slip(scene.end.nodes[3], side * -0.5 * 2); // slips back at the rate 0.5 for dt = 2
    scene.single(EventKind::SLIP_TO_STICK, 3, 0.5);
    scene.start.nodes[3].slip_rate = 0;
    scene.single(EventKind::SLIP_TO_STICK, 3, 0);
    scene.start.nodes[3].slip_rate = 0.1; // stopped before this step already: at once
    scene.single(EventKind::SLIP_TO_STICK, 3, 0);
    scene.end.nodes[3] = scene.start.nodes[3];
    scene.slip(scene.end.nodes[3], side * 1e-3);
    EXPECT_TRUE(scene.earliest().empty()) << "slips on";
  }
}

// Noise of the equilibrium is no slip; a node that has just begun to slide is looked at again in a shorter step.
TEST(Events, SlipBackBeyondTheNoiseOfForces) {
  EventScene scene;
  scene.add_plate(0, 0.3);
  scene.touch(3, NodeState::SLIDING, 1);
  for (Eigen::VectorXd* R : {&scene.R0, &scene.R1}) EventScene::set_force(*R, 3, 1, -0.3);
  scene.start.nodes[3].slip_rate = 1e-6;
  scene.tolerance.closer = 0.25;
  scene.tolerance.compliance = 100; // of the force tolerance 1e-6: slips below 1e-4
  scene.slip(scene.end.nodes[3], -0.9e-4);
  EXPECT_TRUE(scene.earliest().empty());
  scene.slip(scene.end.nodes[3], -0.2e-4);
  EXPECT_EQ(scene.earliest().size(), 1u);
  scene.start.nodes[3].slip_rate = 0;
  scene.single(EventKind::SLIP_TO_STICK, 3, 0.25);
  scene.start.nodes[3].slip_rate = -1e-7; // turned before, within the noise
  scene.single(EventKind::SLIP_TO_STICK, 3, 0);
}

// Slip is a length: on a roller of radius 4 the same turn of s by 0.5e-6 rad is beyond the tolerance 1e-6.
TEST(Events, SlipIsMeasuredAsALength) {
  EventScene scene;
  scene.add(std::make_shared<Circle>(4.), Vector<3>(1, 4, 0), 0.3);
  scene.touch(1, NodeState::SLIDING, 1);
  for (Eigen::VectorXd* R : {&scene.R0, &scene.R1}) (*R)[3] = -1;
  scene.slip(scene.end.nodes[1], -0.5e-6);
  scene.single(EventKind::SLIP_TO_STICK, 1, 0);
  scene.end.nodes[1] = scene.start.nodes[1];
  scene.slip(scene.end.nodes[1], -0.2e-6);
  EXPECT_TRUE(scene.earliest().empty());
}

TEST(Events, FrictionlessNodesNeverStick) {
  EventScene scene;
  scene.add_plate(0, 0);
  scene.touch(3, NodeState::SLIDING, 0);
  scene.slip(scene.end.nodes[3], -0.5);
  EventScene::set_force(scene.R0, 3, 1, 0);
  EventScene::set_force(scene.R1, 3, 2, 0);
  EXPECT_TRUE(scene.earliest().empty());
}

TEST(Events, ReleasedNodesArePassedOver) {
  EventScene scene;
  scene.add_plate(-0.1, 0.3); // everything is inside
  for (int i = 0; i < 6; ++i) scene.start.nodes[i].state = i % 2 ? NodeState::LEAVING : NodeState::RECEDING;
  scene.end = scene.start;
  EXPECT_TRUE(scene.earliest().empty());
  scene.start.nodes[4].state = NodeState::FREE;
  scene.single(EventKind::TOUCH, 4, 0);
}

// The tool comes back to a node that it has left: the event is where its gap leaves the tolerance of 1e-6.
TEST(Events, ReleasedNodesAreMetAgain) {
  for (const NodeState released : {NodeState::LEAVING, NodeState::RECEDING}) {
    EventScene scene;
    for (int i = 0; i < 6; ++i) scene.u0[2 * i + 1] = scene.u1[2 * i + 1] = i == 3 ? 0 : -2;
    scene.add_plate(0, 0.3);
    scene.start.nodes[3].state = released;
    scene.end = scene.start;
    scene.end.q[1] = -1e-5;
    EXPECT_TRUE(scene.earliest().empty());
    scene.tolerance.meets_released = true;
    scene.end.q[1] = -0.9e-6;
    EXPECT_TRUE(scene.earliest().empty());
    scene.end.q[1] = -1e-5;
    scene.single(EventKind::TOUCH, 3, 0.1, 0.011);
  }
}
