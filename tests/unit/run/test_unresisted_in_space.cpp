// Motions in space that no contact resists: left out by rank and told by name; approaches; width of the contact.
#include "kinematics/screw.hpp"
#include "run/contact_motion.hpp"
#include "support/space_scene.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

const std::vector<std::string> ALL{"x", "y", "z", "spinx", "spiny", "spinz"};

std::shared_ptr<const Coordinates<3>> six() { return std::make_shared<CartesianInSpace>(); }

/// Pressed by a force along the normal of the contact, turned by `turn` about its origin, all six coordinates under force.
struct Pressed {
  SpaceScene scene;
  Pressed(std::shared_ptr<const Surface<3>> surface, double height, double mu,
          const Tensor<3>& turn = Tensor<3>::Identity())
      : scene(block(turn), std::move(surface), six(), mu) {
    Eigen::VectorXd q = Eigen::VectorXd::Zero(6);
    q.head<3>() = turn * Vector<3>(0.02, 0.01, height);
    const Eigen::AngleAxisd angle(turn);
    q.tail<3>() = angle.angle() * angle.axis();
    scene.place(q);
    scene.start();
    // one step under motion brings it into the body
    q.head<3>() -= turn * Vector<3>(0, 0, 0.02);
    scene.move(q);
    scene.step(0, 0.1);
  }
  static BlockOfTetrahedra block(const Tensor<3>& turn) {
    BlockOfTetrahedra block;
    block.nx = block.ny = 8;
    block.turn = turn;
    return block;
  }
  void free(const Vector<3>& force) {
    Prescription& p = scene.tool->prescription();
    for (int c = 0; c < 6; ++c) p.force(ALL[c], c < 3 ? force[c] : 0);
  }
  /// Coordinates that the next step would leave out.
  std::vector<std::string> begun() {
    Eigen::VectorXd u = scene.u;
    scene.contact->begin(u, 0.1, 0.1, Stepping::IMPLICIT);
    const std::vector<std::string> found = scene.contact->step().left_out;
    scene.contact->revert();
    return found;
  }
  std::vector<std::string> left_out() { return burnish::left_out(*scene.contact); }
};

std::string names(const std::vector<std::string>& list) {
  std::string text;
  for (const std::string& one : list)
    text += (text.empty() ? "" : " ") + one.substr(12, one.find('"', 12) - 12);
  return text;
}

} // namespace

TEST(UnresistedInSpace, ThreeRotationsOfASmoothBall) {
  Pressed ball(sphere(2), 2, 0);
  ASSERT_FALSE(HasFatalFailure());
  ball.free({0, 0, -0.02});
  EXPECT_EQ(names(ball.begun()), "spinx spiny spinz");
  // along a flat body a smooth ball is in neutral equilibrium: x and y are moved
  ball.scene.tool->prescription().move("x", 0.02);
  ball.scene.tool->prescription().move("y", 0.01);
  ball.scene.step(0.1, 0.1);
  ASSERT_FALSE(HasFatalFailure());
  EXPECT_EQ(names(ball.left_out()), "spinx spiny spinz");
  EXPECT_NEAR(ball.scene.tool->generalized_force()[2], -0.02, 1e-9);
  EXPECT_LE(ball.scene.tool->generalized_force().tail<3>().norm(), 1e-12);
}

// Its frame is not at its center: each dead motion is a turn with a translation.
TEST(UnresistedInSpace, ABallAboutAnotherPoint) {
  AxisFrame center;
  center.point = {0.3, 0.2, -0.5};
  Pressed ball(sphere(2, center), 2.5, 0);
  ASSERT_FALSE(HasFatalFailure());
  Prescription& p = ball.scene.tool->prescription();
  const Vector<3> F(0, 0, -0.02), M = center.point.cross(F); // through its center: no work in a turn about it
  for (int c = 0; c < 6; ++c) p.force(ALL[c], c < 3 ? F[c] : M[c - 3]);
  EXPECT_EQ(ball.begun().size(), 3u);
  for (int c = 3; c < 6; ++c) p.force(ALL[c], 0); // work in turns about the center
  expect_invalid([&] { ball.begun(); }, "has a force but without friction nothing resists it");
}

TEST(UnresistedInSpace, TwoMotionsOfASmoothCylinder) {
  const AxisFrame along_y = axis_frame("test", {0, -4, 0}, {0, 1, 0});
  Pressed roll(cylinder(2, 8, along_y), 2, 0);
  ASSERT_FALSE(HasFatalFailure());
  roll.free({0, 0, -0.02});
  EXPECT_EQ(names(roll.begun()), "y spiny");
  roll.free({0, 1e-6, -0.02});
  expect_invalid([&] { roll.begun(); }, "coordinate \"y\" of tool \"tool\" has a force but without friction");
}

// The axis is along no coordinate: the dead motions are combinations of them, and a coordinate stands for each.
TEST(UnresistedInSpace, ACylinderThatLiesAcross) {
  const AxisFrame across = axis_frame("test", Vector<3>(-4, -4, 0), {1, 1, 0});
  Pressed roll(cylinder(2, 8 * std::sqrt(2.), across), 2, 0);
  ASSERT_FALSE(HasFatalFailure());
  roll.free({0, 0, -0.02});
  EXPECT_EQ(roll.begun().size(), 2u) << names(roll.begun());
  roll.free({0.001, -0.001, -0.02}); // across the axis
  EXPECT_EQ(roll.begun().size(), 2u);
  roll.free({0.001, 0.001, -0.02}); // along it
  expect_invalid([&] { roll.begun(); }, "moved together with");
}

TEST(UnresistedInSpace, ThreeMotionsOfASmoothPlateInAnyPosition) {
  for (const Tensor<3>& turn : {Tensor<3>(Tensor<3>::Identity()), turn_about({1, 2, -1}, 0.9)}) {
    Pressed plate(std::make_shared<PlaneSurface>(Vector<3>(0, 0, 0), Vector<3>(0, 0, -1), 4), 0, 0, turn);
    ASSERT_FALSE(HasFatalFailure());
    plate.free(turn * Vector<3>(0, 0, -0.05));
    plate.scene.step(0.1, 0.1);
    ASSERT_FALSE(HasFatalFailure());
    EXPECT_EQ(plate.left_out().size(), 3u) << names(plate.left_out());
    // the plate tilts in the step, and what is left out holds it then
    const Vector<3> Q = turn.transpose() * plate.scene.tool->generalized_force().head<3>();
    EXPECT_NEAR(Q[2], -0.05, 1e-4);
    EXPECT_LE(Q.head<2>().norm(), 1e-4);
  }
}

// Where the contact resists all that is under force, nothing is left out: a ball with one rotation under motion.
TEST(UnresistedInSpace, WhatIsResistedStays) {
  Pressed ball(sphere(2), 2, 0);
  ASSERT_FALSE(HasFatalFailure());
  Eigen::VectorXd q = ball.scene.tool->q();
  ball.scene.move(q);
  for (const char* c : {"x", "y", "z"}) ball.scene.tool->prescription().force(c, c[0] == 'z' ? -0.02 : 0);
  EXPECT_TRUE(ball.begun().empty());
}

TEST(ApproachInSpace, AlongAnyCoordinateToTheFirstTouch) {
  // a ball over the block, from above and from a slant by a formula, and a tilted cylinder that comes down on its end nodes
  SpaceScene ball({}, sphere(0.5), six(), 0.3);
  ball.place(numbers({0.25, 0.1, 3, 0, 0, 0}));
  ball.start();
  const double z = ball.contact->approach(0, "z", ball.u);
  EXPECT_NEAR(z, std::sqrt(0.25 - 0.25 * 0.25 - 0.1 * 0.1), 1e-12) << "on the node (0.5, 0, 0) or its image";
  SpaceScene slant({}, sphere(0.5),
                   std::make_shared<FormulaCoordinates<3>>("tool", std::vector<std::string>{"s"},
                                                           SpaceFormulas{"1 - 0.3*s", "0.2*s", "2 - s"}),
                   0.3);
  slant.place(numbers({0}));
  slant.start();
  const double s = slant.contact->approach(0, "s", slant.u);
  double least = 1e9;
  for (const int a : slant.setup->candidates())
    least = std::min(least, (Vector<3>(1 - 0.3 * s, 0.2 * s, 2 - s) - slant.mesh.node(a)).norm() - 0.5);
  EXPECT_NEAR(least, 0, 1e-9);
  EXPECT_GT(s, 0.5);
}

TEST(ApproachInSpace, ByAScrewAndFromInside) {
  const AxisFrame axis = axis_frame("test", {0.3, 0.2, 0}, {0, 0, 1});
  SpaceScene scene({}, std::make_shared<PlaneSurface>(Vector<3>(0, 0, 0.5), Vector<3>(0, 0, -1), 4),
                   std::make_shared<Screw>(axis, -0.1), 0.3);
  scene.place(numbers({0}));
  scene.start();
  EXPECT_NEAR(scene.contact->approach(0, "phi", scene.u), 5 * 2 * M_PI, 1e-9);
  SpaceScene inside({}, sphere(0.2), six(), 0.3);
  inside.place(numbers({0, 0, -0.5, 0, 0, 0}));
  inside.start();
  expect_invalid([&] { inside.contact->approach(0, "z", inside.u); },
                 "comes to the surface from inside the workpiece");
  SpaceScene beside({}, sphere(0.2), six(), 0.3);
  beside.place(numbers({5, 0, 3, 0, 0, 0}));
  beside.start();
  expect_invalid([&] { beside.contact->approach(0, "z", beside.u); }, "alone does not bring it to the body");
}

// A long roll: the step control sees the extent along its way, not its length.
TEST(ContactWidthInSpace, AlongTheMotion) {
  BlockOfTetrahedra block;
  block.nx = 8;
  const AxisFrame along_y = axis_frame("test", {0, -4, 0}, {0, 1, 0});
  SpaceScene roll(block, cylinder(2, 8, along_y), six(), 0.3);
  Eigen::VectorXd q = numbers({0, 0, 2, 0, 0, 0});
  roll.place(q);
  roll.start();
  q[2] -= 0.04;
  roll.move(q);
  roll.step(0, 0.1);
  ASSERT_FALSE(HasFatalFailure());
  const double pressed = contact_width(*roll.contact);
  q[0] += 0.02;
  q[4] += 0.01;
  roll.move(q);
  roll.step(0.1, 0.1);
  ASSERT_FALSE(HasFatalFailure());
  double low = 1e9, high = -1e9;
  const auto& state = roll.contact->accepted();
  for (std::size_t i = 0; i < state.contact.nodes.size(); ++i) {
    if (!in_contact(state.contact.nodes[i].state)) continue;
    const double x = roll.setup->body().position(state.u, roll.setup->candidates()[i])[0];
    low = std::min(low, x);
    high = std::max(high, x);
  }
  EXPECT_GT(high - low, 0.2);
  EXPECT_NEAR(contact_width(*roll.contact), high - low, 1e-3);
  EXPECT_LT(pressed, 1) << "the block is 2 wide along the roll";
  q[1] += 0.02; // along its axis
  roll.move(q);
  roll.step(0.2, 0.1);
  ASSERT_FALSE(HasFatalFailure());
  EXPECT_GT(contact_width(*roll.contact), 1.9);
}
