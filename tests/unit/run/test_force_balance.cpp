// Resultants of supports and tools on the workpiece, their moments at the places of the nodes, and their balance.
#include "run/force_balance.hpp"
#include "support/run.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// Block 4 x 1.5 under a rough roller that has turned and pushed; the left upper corner may move up and down only.
struct Pressed : Scene {
  explicit Pressed(double tolerance)
      : Scene(block_mesh(12, 4, 2, 4, 1.5), elastic_material(), options_of(tolerance)) {
    add_tool(std::make_shared<Circle>(3.), std::make_shared<Cartesian>(), 0.3);
    place({1.7, 4.9, 0});
    contact().approach(0, "y", u);
    for (int step = 1; step <= 3; ++step) {
      tool->prescription().move("x", 1.7 + 0.05 * step);
      tool->prescription().move("y", 4.5 - 0.02 * step);
      tool->prescription().move("angle", -0.01 * step);
      EXPECT_EQ(converge(*this, step, 1, Stepping::IMPLICIT), StepStatus::CONVERGED) << why();
      accept(*this, {});
    }
  }
  static IterationOptions options_of(double tolerance) {
    IterationOptions options;
    options.tolerance = tolerance;
    return options;
  }
};

} // namespace

// A force of 2 upward at a node that has moved from (1, 0) to (1, 0.5), and 3 to the right.
TEST(Resultant, MomentAtThePlaceWhereTheNodeIs) {
  BodyView<2> body;
  body.X = Eigen::Vector4d(7, 7, 1, 0);
  const Eigen::Vector4d u(0, 0, 0, 0.5), f(0, 0, 3, 2);
  const auto sum = resultant<2>(body, u, f, {0, 0});
  EXPECT_EQ(sum.force, Vector<2>(3, 2));
  EXPECT_DOUBLE_EQ(sum.moment[0], 1 * 2 - 0.5 * 3);
  EXPECT_DOUBLE_EQ(resultant<2>(body, u, f, {1, 1}).moment[0], 0.5 * 3);
  EXPECT_EQ(resultant<2>(body, u, f, {0, 0}, {0}).force, Vector<2>(0, 0));
}

TEST(Resultant, InSpaceTheMomentIsAVector) {
  BodyView<3> body;
  body.X = Vector<3>(1, 2, 3);
  const auto sum = resultant<3>(body, Eigen::VectorXd(Vector<3>(0, 0, 1)), Vector<3>(4, 5, 6), {0, 0, 0});
  EXPECT_EQ(Vector<3>(sum.moment), Vector<3>(2 * 6 - 4 * 5, 4 * 4 - 1 * 6, 1 * 5 - 2 * 4));
}

TEST(Resultant, OfARingOnlyTheAxialForceRemains) {
  Resultant<2> section;
  section.force = {3, 4};
  section.moment[0] = 5;
  const auto ring = of_ring(section);
  EXPECT_EQ(ring.force, Vector<2>(0, 4));
  EXPECT_EQ(ring.moment[0], 0);
}

// Internal forces have neither resultant nor moment in the deformed body, so all of R has none: to rounding.
TEST(ForceBalance, AllNodalForcesTogetherVanishToRounding) {
  Pressed scene(1e-4);
  const auto& state = scene.contact().accepted();
  const auto all = resultant<2>(scene.contact().setup().body(), state.u, state.R, {0.3, -2});
  const double size = state.R.cwiseAbs().sum();
  EXPECT_GT(size, 1e-2);
  EXPECT_LE(all.force.norm(), 1e-13 * size);
  EXPECT_LE(std::abs(all.moment[0]), 1e-12 * size);
}

TEST(ForceBalance, SupportsAndToolsBalanceToTheTolerance) {
  for (const double tolerance : {1e-4, 1e-9}) {
    Pressed scene(tolerance);
    const ForceBalance<2> forces(scene.contact(), {0.3, -2});
    Resultant<2> sum = forces.reaction();
    const double load = sum.force.norm();
    sum += forces.contact_force(0);
    EXPECT_GT(load, 1e-2);
    EXPECT_LE(sum.force.norm(), 20 * tolerance * load); // as many nodes near the contact carry the residual
    EXPECT_LE(std::abs(sum.moment[0]), 100 * tolerance * load);
    const double imbalance = forces.imbalance(scene.workpiece().internal_force());
    EXPECT_LE(imbalance, 20 * tolerance);
    EXPECT_GT(imbalance, 0);
    EXPECT_LE(forces.external_force(scene.workpiece().internal_force()).force.norm(), 1e-15 * load);
  }
}

// Q_x, Q_y are the force, Q_angle the moment about the tool's center (METHOD.md 2.4).
TEST(ForceBalance, ContactForceIsConjugateToTheCoordinates) {
  Pressed scene(1e-6);
  const Eigen::VectorXd q = scene.tool->q(), Q = scene.tool->generalized_force();
  const auto force = ForceBalance<2>(scene.contact(), {q[0], q[1]}).contact_force(0);
  EXPECT_NEAR(force.force[0], Q[0], 1e-13 * Q.norm());
  EXPECT_NEAR(force.force[1], Q[1], 1e-13 * Q.norm());
  EXPECT_GT(std::abs(Q[2]), 1e-3 * Q.norm());
  EXPECT_NEAR(force.moment[0], Q[2], 1e-6 * Q.norm()); // nodes lie on the circle to the tolerance of places
  EXPECT_EQ(ForceBalance<2>(scene.contact(), {q[0], q[1]}).contact_force(-1).force, force.force);
}

// On a symmetry line the support takes what is across the free component, the tool presses along its normal.
TEST(ForceBalance, OnASymmetryLineToolAndSupportShareTheNode) {
  ContactModel<2> model;
  model.candidates = {0};
  model.tools = {profile_tool("flat", std::make_shared<Segment>(Vector<2>(9, 0), Vector<2>(-9, 0)),
                              std::make_shared<Cartesian>())};
  model.laws.emplace_back(make_coulomb(0.));
  model.first = {0, 3};
  model.constrained = {{true, false}};
  BodyView<2> body;
  body.X = Vector<2>(0, 0);
  body.fixed = {1, 0};
  ContactState<2> state;
  state.q = Eigen::Vector3d(0, 0, 0.5); // turned, so that the normal is not the free component
  state.nodes.resize(1);
  state.nodes[0].state = NodeState::SLIDING;
  state.nodes[0].tool = 0;
  const Eigen::VectorXd R = Vector<2>(3, -4);
  const Eigen::VectorXd tool = contact_forces(model, state, R),
                        support = support_forces(model, body, state, R);
  EXPECT_NEAR(tool[1], -4, 1e-14);
  EXPECT_NEAR(std::abs(tool[0]), 4 * std::tan(0.5), 1e-13);
  EXPECT_NEAR(support[0], 3 - tool[0], 1e-14);
  EXPECT_EQ(support[1], 0);
  state.nodes[0].state = NodeState::FREE;
  EXPECT_EQ(contact_forces(model, state, R).norm(), 0);
  EXPECT_EQ(support_forces(model, body, state, R)[0], 3);
}

TEST(ForceBalance, RefusesAPointThatIsNone) {
  Pressed scene(1e-4);
  EXPECT_THROW(ForceBalance<2>(scene.contact(), {NAN, 0}), std::invalid_argument);
}
