// The convergence test of a step: residuals of free nodes, sliding rows and tools, consistency of states.
#include "contact/balance.hpp"
#include "geometry/circle.hpp"
#include "kinematics/cartesian.hpp"
#include "support/profile_tool.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// Roller of radius 2 on the nodes 0, 1, 2 at its angles -100, -90, -80 degrees; node 3 lies free below it.
struct Scene {
  ContactModel<2> model;
  BodyView<2> body;
  ContactState<2> state;
  PrescribedValues prescribed{{1, 1, 1}, Eigen::VectorXd::Zero(3)};
  Eigen::VectorXd u = Eigen::VectorXd::Zero(8), R = u;
  Tolerances tolerance{1e-6, 1e-3, 1e-3, 1e-3};

  explicit Scene(double mu) {
    model.candidates = {0, 1, 2, 3};
    model.tools = {profile_tool("roller", std::make_shared<Circle>(2.), std::make_shared<Cartesian>())};
    model.laws.emplace_back(make_coulomb(mu));
    model.first = {0, 3};
    body.X = Eigen::VectorXd::Zero(8);
    body.fixed.assign(8, 0);
    body.spacing = 0.3;
    state.q = Vector<3>(0, 2, 0);
    state.nodes.resize(4);
    body.X.segment<2>(6) << 0, -1;
    for (int i = 0; i < 3; ++i) {
      ContactNode<2>& node = state.nodes[i];
      node.state = i == 1 ? NodeState::STICKING : NodeState::SLIDING;
      node.tool = 0;
      const double along = mu > 0 ? i - 1 : 0;
      place_at(node, place_of(*model.tools[0], angle(i)));
      node.slip_direction = along * model.tools[0]->surface().frame(node.place).E;
      body.X.segment<2>(2 * i) << 2 * std::cos(angle(i)), 2 + 2 * std::sin(angle(i));
      set_force(i, 5, -along * mu * 5);
    }
  }
  static double angle(int i) { return (-100 + 10 * i) * M_PI / 180; }
  void set_force(int i, double N, double T) {
    const Vector<2> n(std::cos(angle(i)), std::sin(angle(i)));
    R.segment<2>(2 * i) = N * n + T * Vector<2>(-n.y(), n.x());
  }
  Balance test() const { return balance<2>({model, body, state, prescribed, u, R, tolerance}); }
  /// The slip of node i is counted from ds further along.
  void shift_origin(int i, double ds) {
    state.nodes[i].slip_origin = place_of(*model.tools[0], angle(i) + ds);
  }
};

} // namespace

TEST(Balance, EquilibriumHasNone) {
  const Balance result = Scene(0.2).test();
  EXPECT_NEAR(result.residual, 0, 1e-14);
  EXPECT_EQ(result.inconsistent, 0);
  EXPECT_EQ(result.penetration, 0);
  EXPECT_NEAR(result.load, 5 + 2 * std::hypot(5, 1), 1e-13);
}

TEST(Balance, FreeNodesAndFixedOnes) {
  Scene scene(0.2);
  scene.R[7] = -0.3;
  EXPECT_DOUBLE_EQ(scene.test().residual, 0.3);
  EXPECT_EQ(scene.test().worst_dof, 7);
  scene.body.fixed[7] = 1;
  EXPECT_NEAR(scene.test().residual, 0, 1e-14);
}

// A tolerance of the tool's own makes its rows count more, and those of free nodes within two spacings of its contact.
TEST(Balance, LightToolIsHeldToItsOwnTolerance) {
  Scene scene(0.2);
  scene.tolerance.force = 1e-2;
  scene.tolerance.tool_force = Eigen::VectorXd::Constant(1, 1e-3);
  scene.R[7] = -0.3;
  EXPECT_DOUBLE_EQ(scene.test().residual, 0.3); // one length away
  scene.body.X[7] = -0.5;
  EXPECT_DOUBLE_EQ(scene.test().residual, 3);
  scene.R[7] = 0;
  scene.prescribed.is_motion[1] = 0;
  const double force = scene.test().generalized_force[1];
  scene.prescribed.value[1] = force - 0.05;
  const Balance result = scene.test();
  EXPECT_NEAR(std::abs(result.tool_residual[1]), 0.05, 1e-12);
  EXPECT_NEAR(result.residual, 0.5, 1e-11);
  EXPECT_EQ(result.worst_coordinate, 1);
  EXPECT_DOUBLE_EQ(result.tool_load[0], std::abs(scene.prescribed.value[1])); // more than its contact forces
  scene.tolerance.tool_force[0] = 1; // never less than the common one
  EXPECT_NEAR(scene.test().residual, 0.05, 1e-12);
}

// Before anything is in contact the prescribed force is the load of a tool.
TEST(Balance, PrescribedForceIsALoad) {
  Scene scene(0.2);
  scene.prescribed.is_motion[1] = 0;
  scene.prescribed.value[1] = -400;
  EXPECT_DOUBLE_EQ(scene.test().tool_load[0], 400);
}

TEST(Balance, SlidingRow) {
  Scene scene(0.2);
  scene.set_force(2, 5, -0.8); // mu N = 1
  EXPECT_NEAR(scene.test().residual, 0.2, 1e-14);
  EXPECT_EQ(scene.test().worst_dof, -1);
}

// Tool rows count over their lever arms: a torque of 0.5 on a radius of 2 is a force of 0.25.
TEST(Balance, ToolRowsOverTheirLevers) {
  Scene scene(0.2);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(3);
  for (int i = 0; i < 3; ++i) {
    const Vector<2> F = scene.R.segment<2>(2 * i);
    const Vector<2> arm(2 * std::cos(Scene::angle(i)), 2 * std::sin(Scene::angle(i)));
    force += Vector<3>(F.x(), F.y(), arm.x() * F.y() - arm.y() * F.x());
  }
  EXPECT_LE((scene.test().generalized_force - force).norm(), 1e-13);
  scene.prescribed.is_motion = {1, 0, 0};
  scene.prescribed.value = force + Vector<3>(100, 0.1, 0.5);
  const Balance result = scene.test();
  EXPECT_NEAR(result.residual, 0.25, 1e-13);
  EXPECT_EQ(result.worst_coordinate, 2);
  EXPECT_EQ(result.tool_residual[0], 0) << "under motion";
  EXPECT_NEAR(result.tool_residual[1], -0.1, 1e-13);
  EXPECT_NEAR(result.tool_residual[2], -0.25, 1e-13);
}

TEST(Balance, ToolWithoutContactCannotBalance) {
  Scene scene(0.2);
  for (auto& node : scene.state.nodes) node.state = NodeState::FREE;
  scene.R.setZero();
  scene.prescribed.is_motion = {1, 0, 1};
  scene.prescribed.value[1] = -3;
  EXPECT_DOUBLE_EQ(scene.test().residual, 3);
  EXPECT_EQ(scene.test().worst_coordinate, 1);
}

TEST(Balance, InconsistentStates) {
  const auto count = [](auto change, double mu = 0.2) {
    Scene scene(mu);
    change(scene);
    return scene.test().inconsistent;
  };
  EXPECT_EQ(count([](Scene& s) { s.set_force(1, -0.1, 0); }), 1) << "adhesion";
  EXPECT_EQ(count([](Scene& s) { s.set_force(2, -0.1, 0.02); }), 1) << "adhesion of a sliding node";
  EXPECT_EQ(count([](Scene& s) { s.set_force(1, 5, 1.1); }), 1) << "sticks beyond the limit";
  EXPECT_EQ(count([](Scene& s) { s.set_force(1, 5, -0.9); }), 0);
  EXPECT_EQ(count([](Scene& s) { s.shift_origin(2, 0.01); }), 1) << "slips backwards";
  EXPECT_EQ(count([](Scene& s) { s.shift_origin(0, 0.01); }), 0) << "slips forwards";
  EXPECT_EQ(count([](Scene& s) { s.u[2] = 0.01; }), 1) << "off its tool";
  EXPECT_EQ(count([](Scene& s) { s.u[7] = 2; }), 1) << "a free node inside";
  EXPECT_EQ(count([](Scene& s) { s.shift_origin(2, 0.01); }, 0), 0) << "no friction, no direction";
}

TEST(Balance, PenetrationOfFreeNodes) {
  Scene scene(0.2);
  scene.u[7] = 1.5;
  EXPECT_NEAR(scene.test().penetration, 0.5, 1e-14);
  scene.state.nodes[3].state = NodeState::RECEDING;
  EXPECT_EQ(scene.test().penetration, 0) << "passed over until it has moved away";
  EXPECT_EQ(scene.test().inconsistent, 0);
}

TEST(Balance, NanIsNeverHidden) {
  Scene scene(0.2);
  scene.R[6] = std::nan("");
  EXPECT_FALSE(std::isfinite(scene.test().residual));
}

TEST(CandidateSpacing, MedianOfNearestDistances) {
  Eigen::VectorXd X(10);
  X << 0, 0, 1, 0, 2, 0, 4, 0, 9, 0;
  EXPECT_DOUBLE_EQ(candidate_spacing<2>(X, {0, 1, 2, 3, 4}), 1); // 1, 1, 1, 2, 5
  EXPECT_DOUBLE_EQ(candidate_spacing<2>(X, {0, 2, 3, 4}), 2);    // 2, 2, 2, 5
  EXPECT_DOUBLE_EQ(candidate_spacing<2>(X, {2, 3, 4}), 2);       // 2, 2, 5
  EXPECT_EQ(candidate_spacing<2>(X, {3}), 0);
  EXPECT_EQ(candidate_spacing<2>(X, {}), 0);
}
