// T1 on a real workpiece: stressed P2 triangles under a roller, elastic (rate tangent, exact) and plastic
// (consistent tangent of the single return, of which the symmetric part is taken).
#include "unit/contact/condensed_residual.hpp"
#include "unit/contact/spring_body.hpp"
#include "unit/workpiece/patch.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

const double SIDE = 0.01, RADIUS = 0.03, G = 2.7e10;

UpdateOptions single_return() {
  UpdateOptions options;
  options.update = StressUpdate::SINGLE;
  return options;
}

/// A patch pressed by a roller on its top; corner and middle nodes of the top slide, stick, slide.
struct Pressed {
  Workpiece<2> workpiece;
  BodyView<2> body;
  ContactModel<2> model;
  ContactState<2> state;
  PrescribedValues prescribed{{0, 0, 0}, Eigen::VectorXd::Zero(3)};

  explicit Pressed(double yield_stress, double mu)
      : workpiece(patch(6, SIDE), j2_law<2>(J2Parameters::from_shear(G, 0.32, yield_stress, 0.05 * G)),
                  single_return()) {
    const auto& mesh = workpiece.discretization();
    body.X = Eigen::Map<const Eigen::VectorXd>(mesh.X.data(), mesh.num_dofs());
    body.spacing = SIDE / 4;
    body.fixed.assign(mesh.num_dofs(), 0);
    for (int a : {0, 1, 2}) body.fixed[2 * a] = body.fixed[2 * a + 1] = 1;
    model.candidates = {6, 7, 8};
    model.tools = {profile_tool("roller", std::make_shared<Circle>(RADIUS),
                                std::make_shared<Polar>(Vector<2>(0, -SIDE)))};
    model.laws.emplace_back(make_coulomb(mu));
    model.first = {0, 3};
    state.nodes.resize(3);
  }
  /// Displacement with strains of about `size`, the roller with it, its three nodes on it.
  Eigen::VectorXd press(double size) {
    Eigen::VectorXd u = -bent(workpiece.discretization(), SIDE, size);
    for (int a : {0, 1, 2}) u.segment<2>(2 * a).setZero();
    const Vector<2> center(0.5 * SIDE, 2 * SIDE + RADIUS - size * SIDE);
    state.q = Vector<3>(center.norm(), std::atan2(center.y(), center.x()), 0.2);
    const auto poses = model.poses(state.q);
    const double sign = model.laws[0].frictionless() ? 0 : 1, signs[] = {sign, 0, -sign};
    for (int i = 0; i < 3; ++i) {
      ContactNode<2>& node = state.nodes[i];
      const int dof = 2 * model.candidates[i];
      node.tool = 0;
      node.state = i == 1 ? NodeState::STICKING : NodeState::SLIDING;
      const Tool<2>& tool = *model.tools[0];
      place_at(node, tool.foot(poses[0], body.position(u, model.candidates[i]), node.place.hint).place);
      node.slip_direction = signs[i] * tool.surface().frame(node.place).E;
      u.segment<2>(dof) = tool.position(poses[0], node.place) - body.X.segment<2>(dof);
    }
    return u;
  }
  Eigen::VectorXd force(const Eigen::VectorXd& u) {
    EXPECT_EQ(workpiece.update(u, 1, 0).status, UpdateStatus::OK);
    return workpiece.internal_force();
  }
  void compare(const Eigen::VectorXd& u, const NodeBlockMatrix<2>& K, double step, double tolerance) {
    const auto kind = unknowns(model, state, prescribed, body);
    const Eigen::VectorXd R = force(u);
    Condensation<2> condensation(model, body);
    const auto computed = dense(condensation.condense(
        {K, state, prescribed, prescribed, u, R, GeometricTerms::COMPLETE, RightHandSide::TOTAL, false}));
    const auto expected = differenced(
        model, body, [this](const Eigen::VectorXd& x) { return force(x); }, state, u, kind, step);
    expect_blocks(computed, expected, kind, tolerance);
  }
};

void check_elastic(double mu) {
  Pressed sample(1e3 * G, mu);
  const Eigen::VectorXd u = sample.press(0.02);
  sample.force(u);
  sample.workpiece.accept();
  NodeBlockMatrix<2> K = sample.workpiece.pattern();
  sample.workpiece.tangent(K, TangentKind::RATE);
  sample.compare(u, K, 1e-6, 1e-9);
}

} // namespace

TEST(CondensedBody, ElasticWithFriction) { check_elastic(0.2); }
TEST(CondensedBody, ElasticWithoutFriction) { check_elastic(0); }

// Of the exact derivative of the single return the symmetric part is kept: the error is a part of the step's
// strain and falls with the step (measured: below 4e-3 of the strain).
TEST(CondensedBody, PlasticSingleReturn) {
  for (const double step : {2e-3, 2e-4}) {
    Pressed sample(1e-3 * G, 0.2);
    sample.force(sample.press(0.02));
    sample.workpiece.accept();
    const Eigen::VectorXd u = sample.press(0.02 + step);
    sample.force(u);
    for (const char plastic : sample.workpiece.state().plastic) ASSERT_TRUE(plastic);
    NodeBlockMatrix<2> K = sample.workpiece.pattern();
    sample.workpiece.tangent(K, TangentKind::CONSISTENT);
    sample.compare(u, K, 1e-9, 1e-2 * step);
  }
}
