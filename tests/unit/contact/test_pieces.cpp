// Passing from one piece of a tool's profile to the next: located where the sliding node meets the joint.
#include "geometry/arc_chain.hpp"
#include "unit/contact/event_scene.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// A die facing down: flat from x = 20 to x = 2, a fillet of radius 1, then up a wall. s = 17 at the joint.
std::shared_ptr<const ArcChain> die() {
  return std::make_shared<ArcChain>(std::vector<Vector<2>>{{20, 0}, {2, 0}, {2, 10}},
                                    std::vector<double>{0, 1, 0});
}

EventScene sliding_scene(double s0, double s1) {
  EventScene scene;
  scene.add(die(), Vector<3>(0, 0, 0), 0.3);
  scene.touch(4, NodeState::SLIDING, 1);
  scene.start.nodes[4].place = place_of(*scene.model.tools[0], s0);
  scene.start.nodes[4].slip_rate = s0;
  scene.end.nodes[4] = scene.start.nodes[4];
  scene.end.nodes[4].place = place_of(*scene.model.tools[0], s1);
  for (Eigen::VectorXd* R : {&scene.R0, &scene.R1}) EventScene::set_force(*R, 4, 1, -0.3);
  return scene;
}

} // namespace

TEST(Pieces, PassageIsLocatedJustBeyondTheJoint) {
  const EventScene scene = sliding_scene(16.8, 17.6); // the joint after a quarter of the step
  const auto event = scene.single(EventKind::NEXT_PIECE, 4, 0.25, 1e-9);
  const double s = 16.8 + event.fraction * 0.8;
  EXPECT_EQ(die()->piece(Param<2>(s)), 1) << "a step cut at the event must start on the new piece";
}

TEST(Pieces, NoEventOnOnePiece) {
  EXPECT_TRUE(sliding_scene(16.2, 16.9).earliest().empty());
  EXPECT_TRUE(sliding_scene(17.1, 17.5).earliest().empty());
}

TEST(Pieces, PassageChangesNoState) {
  EventScene scene = sliding_scene(16.8, 17.6);
  const auto events = scene.earliest();
  ContactState<2> after = scene.end;
  apply_events(scene.model, scene.body, events, scene.u1, after);
  EXPECT_EQ(after.nodes[4].state, NodeState::SLIDING);
  EXPECT_EQ(after.nodes[4].slip_direction, scene.end.nodes[4].slip_direction);
}

TEST(Pieces, ImplicitStepsLogIt) {
  const EventScene scene = sliding_scene(16.8, 17.6);
  const auto changes = state_changes(scene.model, scene.body, scene.step());
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].kind, EventKind::NEXT_PIECE);
  EXPECT_NEAR(changes[0].fraction, 0.25, 1e-9);
}
