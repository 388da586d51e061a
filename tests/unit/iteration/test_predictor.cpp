// The predicted state: the last increment and the contact states carried along with the tool.
#include "geometry/circle.hpp"
#include "geometry/segment.hpp"
#include "iteration/predictor.hpp"
#include "kinematics/cartesian.hpp"
#include "kinematics/polar.hpp"
#include "support/profile_tool.hpp"
#include "support/structured_mesh.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// Block of 8 x 1 (nodes half a unit apart on top) under a plate that lies on it; x of the plate is moved.
struct Carried {
  ContactMesh mesh = block_mesh(8, 2, 2, 8, 1);
  ContactModel<2> model;
  BodyView<2> body;
  ContactState<2> state;
  PrescribedValues prescribed{{1, 1, 0}, Vector<3>(0.5, 1, -7)};
  Eigen::VectorXd u;
  StepHistory<2> history;

  Carried() {
    body.X = Eigen::Map<const Eigen::VectorXd>(mesh.space.X.data(), mesh.space.num_dofs());
    body.fixed = mesh.fixed;
    body.spacing = 0.5;
    u = 1e-3 * body.X;
    for (Eigen::Index d = 1; d < u.size(); d += 2) u[d] = 0;
    model.candidates = nodes_along(mesh.surface);
    model.tools = {profile_tool("plate", std::make_shared<Segment>(Vector<2>(20, 0), Vector<2>(-20, 0)),
                                std::make_shared<Cartesian>())};
    model.laws.emplace_back(make_coulomb(0.3));
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
  /// @param along 1, -1: slides along the tangent (smaller x) or against it
  void touch(int i, NodeState now, double along) {
    ContactNode<2>& node = state.nodes[i];
    node.state = now;
    node.tool = 0;
    place_at(node, place_of(*model.tools[0], 20 - body.position(u, model.candidates[i])[0]));
    node.slip_direction = along * model.tools[0]->surface().frame(node.place).E;
  }
  Prediction<2> predict_step(double dt, bool carry = true) const {
    return Predictor<2>(mesh.space, model, body).predict(prescribed, state, u, history, dt, {carry});
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
  for (std::size_t i = 0; i < result.entry.nodes.size(); ++i) {
    EXPECT_EQ(result.entry.nodes[i].tool, 0);
    EXPECT_NEAR(result.entry.nodes[i].place.hint[0],
                20 - carried.body.position(carried.u, carried.model.candidates[i])[0], 1e-13);
    EXPECT_EQ(result.entry.nodes[i].slip_origin.y, result.entry.nodes[i].place.y);
  }
}

// The plate goes on by `way` over material that hardly moves: every node moves as the place behind it by that way did, in
// proportion to the time, but for squares of the increments.
TEST(Predictor, LastIncrementCarriedAlong) {
  constexpr double small = 1e-6;
  struct Case {
    double dt, way;
  };
  for (const Case now : {Case{2, 0.5}, Case{1, 0.5}, Case{4, 1.1}}) {
    Carried carried;
    carried.u.setZero();
    carried.remember(2);
    carried.history.du *= small;
    carried.history.own = false;
    carried.prescribed.value[0] = now.way;
    const auto result = carried.predict_step(now.dt);
    double worst = 0;
    for (int a = 0; a < carried.mesh.space.num_nodes; ++a) {
      const Vector<2> x = carried.mesh.space.node(a), behind = x - Vector<2>(now.way, 0);
      if (std::abs(behind.x()) < 1e-3) continue; // on the border of the mesh: inside or outside by rounding
      Vector<2> expected = now.dt / 2 * small * Carried::increment(behind.x() < -0.21 ? x : behind);
      if (carried.mesh.fixed[2 * a]) expected.setZero();
      const Vector<2> moved = (result.u - carried.u).segment<2>(2 * a);
      worst = std::max(worst, (moved - expected).norm());
    }
    EXPECT_LE(worst, 30 * small * small) << "way " << now.way;
    EXPECT_NEAR(result.state.q[2], 0.1 * now.dt / 2, 1e-15) << "coordinates under force go on";
  }
}

// A tool that goes with the material carries nothing: each node repeats its own increment, turned by the rotation of its
// elements. A strip that turned by an angle turns by it again, without stretch; unturned, its length would grow by 1 - cos.
TEST(Predictor, TurnedStripIsNotStretched) {
  for (const double dt : {1., 0.5, 2.}) {
    Carried carried;
    constexpr double angle = 0.02;
    carried.mesh.fixed.assign(carried.mesh.fixed.size(), 0);
    carried.body.fixed = carried.mesh.fixed;
    carried.remember(1);
    const auto turned = [&](double by) {
      Eigen::VectorXd u = carried.u;
      for (Eigen::Index d = 0; d < u.size(); d += 2) {
        const Vector<2> X = carried.body.X.segment<2>(d);
        u.segment<2>(d) = plane_rotation(by) * X - X;
      }
      return u;
    };
    carried.u = turned(angle);
    carried.history.du = carried.u - turned(0);
    carried.history.own = true;
    const auto own = carried.predict_step(dt);
    const Eigen::VectorXd x = carried.body.X + own.u;
    const Eigen::VectorXd& X = carried.body.X;
    double stretch = 0;
    for (int a = 1; a < carried.mesh.space.num_nodes; ++a)
      stretch = std::max(stretch, std::abs((x.segment<2>(2 * a) - x.segment<2>(0)).norm() /
                                               (X.segment<2>(2 * a) - X.segment<2>(0)).norm() -
                                           1));
    EXPECT_LE(stretch, dt == 1 ? 1e-14 : 0.5 * std::abs(dt - dt * dt) * angle * angle);
  }
}

// A roller that turns about a pivot carries the increment along the ring and turns it.
TEST(Predictor, IncrementTurnsWithThePivot) {
  const auto mesh = ring_mesh(32, 4, 2, 25, 30, 0.8, 1);
  ContactModel<2> model;
  model.candidates = nodes_along(mesh.surface);
  model.tools = {profile_tool("roller", std::make_shared<Circle>(15.), std::make_shared<Polar>())};
  model.laws.emplace_back(make_coulomb(0.3));
  model.first = {0, 3};
  const BodyView<2> body{Eigen::Map<const Eigen::VectorXd>(mesh.space.X.data(), mesh.space.num_dofs()),
                         mesh.fixed, 0.5, nullptr};
  ContactState<2> state;
  state.nodes.resize(model.candidates.size());
  state.q = Vector<3>(50, 1.6, 0); // clear of the ring
  const double turn = -0.06;
  StepHistory<2> history;
  history.dt = 1;
  history.own = false;
  history.dq = Vector<3>(0, turn, 0);
  history.q_old = state.q - history.dq;
  const auto increment = [](double angle) { // along the radius
    return Vector<2>(1e-5 * std::sin(3 * angle) * plane_direction(angle));
  };
  history.du.resize(body.X.size());
  const auto angle_of = [&](int a) { return std::atan2(body.X[2 * a + 1], body.X[2 * a]); };
  for (int a = 0; a < mesh.space.num_nodes; ++a) history.du.segment<2>(2 * a) = increment(angle_of(a));
  const Eigen::VectorXd u = Eigen::VectorXd::Zero(body.X.size());
  const auto result = Predictor<2>(mesh.space, model, body)
                          .predict({{1, 1, 1}, Vector<3>(50, 1.6 + turn, 0)}, state, u, history, 1, {});
  for (int a = 0; a < mesh.space.num_nodes; ++a) {
    const double behind = angle_of(a) - turn;
    if (mesh.fixed[2 * a] || behind > M_PI / 2 + 0.4) continue;
    EXPECT_LE((result.u.segment<2>(2 * a) - plane_rotation(turn) * increment(behind)).norm(), 1e-9)
        << "node " << a;
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
  carried.prescribed.is_motion[2] = 1;
  carried.prescribed.value[2] = 0;
  const auto result = carried.predict_step(1);
  // 5: slides toward smaller x as the plate leaves in +x, which is +s: agrees with its sign 1
  const char* expected[] = {"free",    "free",     "free",     "free",     "free",
                            "sliding", "sticking", "sticking", "sticking", "free"};
  for (int i = 0; i < 10; ++i) EXPECT_STREQ(name_of(result.state.nodes[i].state), expected[i]) << i;
  EXPECT_EQ(result.state.nodes[5].slip_direction, carried.state.nodes[4].slip_direction);
  EXPECT_EQ(result.state.nodes[8].slip_direction.norm(), 0) << "would slip against its sign: sticks";
  const int node = carried.model.candidates[6];
  EXPECT_EQ(result.u[2 * node], carried.u[2 * node]) << "the first iteration moves nodes, by the whole body";
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
