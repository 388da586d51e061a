// The dense contact block on the Schur complement against the sparse condensed system, solved by UMFPACK and
// by the bordered solver.
#include "contact/contact_block.hpp"
#include "solver/bordered_solver.hpp"
#include "solver/schur_factor.hpp"
#include "solver/unsymmetric_solver.hpp"
#include "unit/contact/condensed_residual.hpp"
#include "unit/contact/spring_body.hpp"
#include <numeric>

using namespace burnish;
using namespace burnish::test;

namespace {

/// Roller and line, in contact with four of six candidates, nodes a little off their tools.
struct Scene {
  SpringBody spring{0};
  SpringContact contact;
  Eigen::VectorXd u = 0.2 * Eigen::VectorXd::LinSpaced(24, -1, 2).array().sin();
  Eigen::VectorXd R;
  std::vector<int> active;
  std::vector<NodeLinearization<2>> nodes;
  std::vector<int> free; ///< all components are
  Eigen::MatrixXd C;
  ActivePart flexibility;
  ContactBlockInput<2> input;

  explicit Scene(double mu) {
    contact.add(make_tool("roller", Shape::CIRCLE, Frame::POLAR), mu);
    contact.add(make_tool("line", Shape::SEGMENT, Frame::CARTESIAN), mu / 2);
    contact.touch(0, 0, 0.3, mu > 0 ? -1 : 0, true);
    contact.touch(1, 0, 0.9, 0, false);
    contact.touch(3, 1, 0.7, mu > 0 ? 1 : 0, true);
    contact.touch(4, 1, 1.2, 0, false);
    contact.prescribed.value << 0.4, contact.state.q[1] + 0.02, -0.3, 0.2, -0.5, contact.state.q[5] - 0.01;
    contact.prescribed.is_motion[1] = contact.prescribed.is_motion[5] = 1;
    spring.body.fixed[0] = spring.body.fixed[21] = 1;
    contact.settle(spring.body, u);
    for (int i : {0, 3}) u[2 * contact.model.candidates[i]] += 0.01; // offsets
    R = spring.force(u);
    prepare();
  }
  void prepare() {
    SchurFactor<2> factor;
    const auto& K = spring.tangent(u);
    factor.analyze(K, spring.body.fixed, contact.model.candidates);
    ASSERT_EQ(factor.factorize(K), FactorStatus::OK);
    const Eigen::MatrixXd all = *factor.candidate_flexibility();
    const Eigen::VectorXd free = factor.solve(-R);
    const auto poses = contact.model.poses(contact.state.q);
    for (int i = 0; i < 6; ++i)
      if (in_contact(contact.state.nodes[i].state)) active.push_back(i);
    const Eigen::Index n = 2 * static_cast<Eigen::Index>(active.size());
    C.resize(n, n);
    input.free_increment.resize(n);
    input.offset.resize(n);
    for (std::size_t a = 0; a < active.size(); ++a) {
      const int i = active[a], dof = 2 * contact.model.candidates[i];
      nodes.push_back(linearize_node(contact.model, contact.state.nodes[i], i, poses,
                                     Vector<2>(R.segment<2>(dof)), GeometricTerms::COMPLETE));
      input.offset.segment<2>(2 * a) = nodes.back().point.x - spring.body.position(u, dof / 2);
      input.free_increment.segment<2>(2 * a) = free.segment<2>(dof);
      for (std::size_t b = 0; b < active.size(); ++b)
        C.block<2, 2>(2 * a, 2 * b) = all.block<2, 2>(2 * i, 2 * active[b]);
    }
    set_flexibility(C);
  }
  void set_flexibility(const Eigen::MatrixXd& matrix) {
    free.resize(matrix.rows());
    std::iota(free.begin(), free.end(), 0);
    flexibility.set(std::make_shared<Eigen::MatrixXd>(matrix));
    positive = flexibility.select(free);
    input.nodes = &nodes;
    input.free = &free;
    input.flexibility = &flexibility;
  }
  bool positive = false;
  ContactBlockSolution<2> solve_block() const {
    return solve_contact_block(contact.model, contact.prescribed, contact.state.q, input);
  }
};

template <class Solver> void compare_with(Scene& scene) {
  Condensation<2> condensation(scene.contact.model, scene.spring.body);
  const auto& system = condensation.condense(
      {scene.spring.tangent(scene.u), scene.contact.state, scene.contact.prescribed, scene.contact.prescribed,
       scene.u, scene.R, GeometricTerms::COMPLETE, RightHandSide::TOTAL, false});
  Solver solver;
  ASSERT_EQ(solver.factorize(view(system)), FactorStatus::OK);
  const auto step = condensation.expand(solver.solve(system.rhs));
  const auto block = scene.solve_block();
  ASSERT_FALSE(block.singular);
  expect_close(block.dq, step.dq, step.dq.norm(), 1e-11, "dq");
  const Eigen::VectorXd force = scene.R + scene.spring.tangent(scene.u).multiply(step.du);
  Eigen::MatrixXd slip(1, block.slip.cols());
  Eigen::VectorXd F(block.F.size());
  for (std::size_t a = 0; a < scene.active.size(); ++a) {
    slip.col(static_cast<Eigen::Index>(a)) = step.slip.col(scene.active[a]);
    F.segment<2>(2 * a) = force.segment<2>(2 * scene.contact.model.candidates[scene.active[a]]);
  }
  expect_close(block.slip, slip, slip.norm(), 1e-11, "slip");
  expect_close(block.F, F, F.norm(), 1e-11, "F");
  EXPECT_GE(slip.norm(), 1e-3);
}

} // namespace

TEST(ContactBlock, AgreesWithUmfpack) {
  Scene friction(0.3), smooth(0);
  compare_with<UnsymmetricSolver>(friction);
  compare_with<UnsymmetricSolver>(smooth);
}

TEST(ContactBlock, AgreesWithTheBorderedSolver) {
  Scene friction(0.3), smooth(0);
  compare_with<BorderedSolver>(friction);
  compare_with<BorderedSolver>(smooth);
}

// The solution obeys the linearized rows themselves.
TEST(ContactBlock, RowsOfTheToolsBalance) {
  Scene scene(0.3);
  const auto block = scene.solve_block();
  ASSERT_FALSE(block.singular);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(6);
  for (std::size_t a = 0; a < scene.nodes.size(); ++a) {
    const auto& node = scene.nodes[a];
    const Vector<2> F = block.F.segment<2>(2 * a);
    const Eigen::VectorXd dq = scene.contact.model.tool_q(block.dq, node.tool);
    const Param<2> slip = block.slip.col(static_cast<Eigen::Index>(a));
    force.segment<3>(3 * node.tool) +=
        node.point.x_q.transpose() * F + node.geo_qq * dq + node.geo_qs.transpose() * slip;
    if (node.sliding) {
      const Param<2> row = node.W.transpose() * F + node.constant + node.geo_ss * slip + node.geo_sq * dq;
      EXPECT_NEAR(row[0], 0, 1e-13);
    }
  }
  for (int k : {0, 2, 3, 4}) EXPECT_NEAR(force[k], scene.contact.prescribed.value[k], 1e-12) << k;
  EXPECT_NEAR(block.dq[1], 0.02, 1e-15);
  EXPECT_NEAR(block.dq[5], -0.01, 1e-15);
}

// A frictionless roller under torque: nothing resists its rotation, and the block names the coordinate.
TEST(ContactBlock, NamesTheCoordinateWithoutSupport) {
  Scene scene(0);
  scene.contact.prescribed.is_motion[3] = 1; // or nothing would resist the line along itself
  const auto poses = scene.contact.model.poses(scene.contact.state.q);
  for (std::size_t a = 0; a < scene.nodes.size(); ++a) {
    auto node = scene.contact.state.nodes[scene.active[a]];
    node.state = NodeState::SLIDING;
    scene.nodes[a] = linearize_node(scene.contact.model, node, scene.active[a], poses,
                                    Vector<2>(Vector<2>::Zero()), GeometricTerms::NONE);
  }
  const auto block = scene.solve_block();
  EXPECT_TRUE(block.singular);
  EXPECT_EQ(block.weakest_coordinate, 2);
}

// There is no factor of a flexibility that is not positive definite, and the selection says so.
TEST(ContactBlock, IndefiniteFlexibilityHasNoFactor) {
  Scene scene(0.3);
  EXPECT_TRUE(scene.positive);
  Eigen::MatrixXd C = scene.C;
  C(0, 0) = -1;
  scene.set_flexibility(C);
  EXPECT_FALSE(scene.positive);
}

// A tool that touches nothing has no row at all: its first coordinate under force is named.
TEST(ContactBlock, ToolWithoutContact) {
  Scene scene(0.3);
  for (auto& node : scene.nodes) node = scene.nodes[0];
  const auto block = scene.solve_block();
  EXPECT_TRUE(block.singular);
  EXPECT_EQ(block.weakest_coordinate, 3);
}

// A stiffness added to the tangent before it is factorized, and taken off in the block, leaves no trace: also on
// a node that is not in contact.
TEST(ContactBlock, AddedStiffnessLeavesNoTrace) {
  for (const double mu : {0., 0.3}) {
    Scene scene(mu);
    const auto plain = scene.solve_block();
    NodeBlockMatrix<2> K = scene.spring.tangent(scene.u);
    const std::vector<int> stiffened = {0, 2, 4}; // candidates; 2 is not in contact
    std::vector<int> active = {0, 1, 2, 3, 4};
    Eigen::VectorXd added = Eigen::VectorXd::Zero(10);
    for (const int i : stiffened) {
      const int node = scene.contact.model.candidates[i];
      for (int c = 0; c < 2; ++c) {
        if (scene.spring.body.fixed[2 * node + c]) continue;
        added[2 * i + c] = 1.5 + i + c;
        K.block(K.find(node, node))[3 * c] += added[2 * i + c];
      }
    }
    SchurFactor<2> factor;
    factor.analyze(K, scene.spring.body.fixed, scene.contact.model.candidates);
    ASSERT_EQ(factor.factorize(K), FactorStatus::OK);
    const Eigen::MatrixXd all = *factor.candidate_flexibility();
    const Eigen::VectorXd free = factor.solve(-scene.R);
    std::vector<NodeLinearization<2>> nodes;
    Eigen::MatrixXd C(10, 10);
    ContactBlockInput<2>& input = scene.input;
    const Eigen::VectorXd offsets = input.offset;
    input.offset = input.free_increment = Eigen::VectorXd::Zero(10);
    for (int a = 0, known = 0; a < 5; ++a) {
      if (a == 2) {
        nodes.emplace_back();
        nodes.back().in_contact = false;
      } else {
        nodes.push_back(scene.nodes[known]);
        input.offset.segment<2>(2 * a) = offsets.segment<2>(2 * known++);
      }
      input.free_increment.segment<2>(2 * a) = free.segment<2>(2 * scene.contact.model.candidates[a]);
      for (int b = 0; b < 5; ++b) C.block<2, 2>(2 * a, 2 * b) = all.block<2, 2>(2 * a, 2 * b);
    }
    scene.nodes = nodes;
    scene.set_flexibility(C);
    input.added_stiffness = added;
    const auto with = scene.solve_block();
    ASSERT_FALSE(with.singular);
    EXPECT_LT((with.dq - plain.dq).norm(), 1e-11 * plain.dq.norm());
    for (int a = 0, known = 0; a < 5; ++a) {
      if (a == 2) {
        EXPECT_LT(with.F.segment<2>(4).norm(), 1e-11 * plain.F.norm())
            << "no force on a node that is not in contact";
        continue;
      }
      EXPECT_LT((with.F.segment<2>(2 * a) - plain.F.segment<2>(2 * known)).norm(), 1e-10 * plain.F.norm());
      EXPECT_NEAR(with.slip(0, a), plain.slip(0, known), 1e-11);
      ++known;
    }
  }
}
