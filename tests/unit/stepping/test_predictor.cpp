// The predicted state: the last increment and the contact states carried along with the tool.
#include "geometry/segment.hpp"
#include "kinematics/cartesian.hpp"
#include "stepping/predictor.hpp"
#include "support/structured_mesh.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// Block of 8 x 1 (nodes half a unit apart on top) under a plate that lies on it; x of the plate is moved.
struct Carried {
  ContactMesh mesh = block_mesh(8, 2, 2, 8, 1);
  MeshLocator<2> locator{mesh.space};
  ContactModel<2> model;
  BodyView<2> body;
  ContactState<2> state;
  Program program{{1, 1, 0}, Vector<3>(0.5, 1, -7)};
  Eigen::VectorXd u;
  StepHistory<2> history;

  Carried() {
    body.X = Eigen::Map<const Eigen::VectorXd>(mesh.space.X.data(), mesh.space.num_dofs());
    body.fixed = mesh.fixed;
    body.spacing = 0.5;
    u = 1e-3 * body.X;
    for (Eigen::Index d = 1; d < u.size(); d += 2) u[d] = 0;
    model.candidates = nodes_along(mesh.surface);
    model.tools = {std::make_shared<Tool<2>>("plate",
                                             std::make_shared<Segment>(Vector<2>(20, 0), Vector<2>(-20, 0)),
                                             std::make_shared<Cartesian>())};
    model.friction = {make_coulomb(0.3)};
    model.first = {0, 3};
    state.q = Vector<3>(0, 1, 0);
    state.nodes.resize(model.candidates.size());
  }
  /// The step before moved the plate by 0.5 in `dt`; increments are linear in space.
  void remember(double dt) {
    history.dt = dt;
    history.q_old = Vector<3>(-0.5, 1, 0);
    history.dq = Vector<3>(0.5, 0, 0.1);
    history.du.resize(u.size());
    for (Eigen::Index d = 0; d < u.size(); d += 2) history.du.segment<2>(d) = increment(body.X.segment<2>(d));
  }
  static Vector<2> increment(const Vector<2>& x) {
    return 1e-2 * Vector<2>(x[0] + 2 * x[1], 1 - x[0] * x[1]);
  }
  void touch(int i, NodeState now, double slip_sign) {
    ContactNode<2>& node = state.nodes[i];
    node.state = now;
    node.tool = 0;
    node.s[0] = node.s_ref[0] = 20 - body.position(u, model.candidates[i])[0];
    node.slip_sign = slip_sign;
  }
  Prediction<2> predict_step(double dt, bool carry = true) const {
    return predict(model, body, locator, mesh.space, program, state, u, history, dt, carry);
  }
};

} // namespace

TEST(Predictor, FirstStepOnlyMovesTheTool) {
  Carried carried;
  carried.touch(3, NodeState::TOUCHED, 0);
  const auto result = carried.predict_step(1);
  EXPECT_EQ(result.u, carried.u);
  EXPECT_EQ(result.state.q, Eigen::VectorXd(Vector<3>(0.5, 1, 0))) << "motions to their values, others stay";
  EXPECT_STREQ(name_of(result.state.nodes[3].state), "sticking") << "a touched node is held";
  for (std::size_t i = 0; i < result.entry.size(); ++i) {
    EXPECT_EQ(result.entry[i].tool, 0);
    EXPECT_NEAR(result.entry[i].s[0], 20 - carried.body.position(carried.u, carried.model.candidates[i])[0],
                1e-13);
    EXPECT_EQ(result.entry[i].s_ref, result.entry[i].s);
  }
}

// The plate went on by 0.5 in the last step and goes by 0.5 in this one, in the same time: every node moves
// as the place half a unit behind it did, P2 exactly.
TEST(Predictor, LastIncrementCarriedAlong) {
  for (const double dt : {2., 1.}) {
    Carried carried;
    carried.remember(2);
    const auto result = carried.predict_step(dt);
    double worst = 0;
    for (int a = 0; a < carried.mesh.space.num_nodes; ++a) {
      const Vector<2> x = carried.mesh.space.node(a), behind = x - Vector<2>(0.5, 0);
      Vector<2> expected = dt / 2 * Carried::increment(behind.x() < -0.1 ? x : behind);
      if (carried.mesh.fixed[2 * a]) expected.setZero();
      worst = std::max(worst, (result.u - carried.u).segment<2>(2 * a).operator-(expected).norm());
    }
    EXPECT_LE(worst, 1e-14);
    EXPECT_NEAR(result.state.q[2], 0.1 * dt / 2, 1e-15) << "coordinates under force go on";
  }
}

// One node spacing further: node i takes the state that node i - 1 had.
TEST(Predictor, StatesCarriedAlong) {
  Carried carried;
  carried.remember(1);
  carried.history.du.setZero();
  carried.touch(4, NodeState::SLIDING, 1);
  carried.touch(5, NodeState::STICKING, 0);
  carried.touch(6, NodeState::STICKING, 0);
  carried.touch(7, NodeState::SLIDING, -1);
  carried.program.is_motion[2] = 1;
  carried.program.value[2] = 0;
  const auto result = carried.predict_step(1);
  // 5: slides toward smaller x as the plate leaves in +x, which is +s: agrees with its sign 1
  const char* expected[] = {"free",    "free",     "free",     "free",     "free",
                            "sliding", "sticking", "sticking", "sticking", "free"};
  for (int i = 0; i < 10; ++i) EXPECT_STREQ(name_of(result.state.nodes[i].state), expected[i]) << i;
  EXPECT_EQ(result.state.nodes[5].slip_sign, 1);
  EXPECT_EQ(result.state.nodes[8].slip_sign, 0) << "would slip against its sign: sticks";
  const int node = carried.model.candidates[6];
  EXPECT_NEAR(result.u[2 * node] - carried.u[2 * node], 0.5, 1e-13) << "sticking nodes go with the plate";
  const int fresh = carried.model.candidates[8];
  EXPECT_NEAR(carried.body.position(result.u, fresh)[1], 1, 1e-13) << "contact nodes lie on the tool";
}

TEST(Predictor, EventSteppingKeepsItsStates) {
  Carried carried;
  carried.remember(2);
  carried.touch(4, NodeState::SLIDING, -1);
  carried.touch(5, NodeState::STICKING, 0);
  const auto result = carried.predict_step(1, false);
  for (std::size_t i = 0; i < result.state.nodes.size(); ++i)
    EXPECT_STREQ(name_of(result.state.nodes[i].state), name_of(carried.state.nodes[i].state)) << i;
  const int free_node = carried.model.candidates[12];
  EXPECT_LE((result.u - carried.u - 0.5 * carried.history.du).segment<2>(2 * free_node).norm(), 1e-15);
  for (Eigen::Index d = 0; d < result.u.size(); ++d)
    if (carried.body.fixed[d]) {
      ASSERT_EQ(result.u[d], carried.u[d]) << "fixed dof " << d;
    }
}
