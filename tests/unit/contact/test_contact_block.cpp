// The dense contact block on the Schur complement against the sparse condensed system, solved by UMFPACK and
// by the bordered solver.
#include "contact/contact_block.hpp"
#include "solver/bordered_solver.hpp"
#include "solver/schur_factor.hpp"
#include "solver/unsymmetric_solver.hpp"
#include "unit/contact/condensed_residual.hpp"
#include "unit/contact/spring_body.hpp"

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
  Eigen::MatrixXd flexibility;
  ContactBlockInput<2> input;

  explicit Scene(double mu) {
    contact.add(make_tool("roller", Shape::CIRCLE, Frame::POLAR), mu);
    contact.add(make_tool("line", Shape::SEGMENT, Frame::CARTESIAN), mu / 2);
    contact.touch(0, 0, 0.3, mu > 0 ? -1 : 0, true);
    contact.touch(1, 0, 0.9, 0, false);
    contact.touch(3, 1, 0.7, mu > 0 ? 1 : 0, true);
    contact.touch(4, 1, 1.2, 0, false);
    contact.program.value << 0.4, contact.state.q[1] + 0.02, -0.3, 0.2, -0.5, contact.state.q[5] - 0.01;
    contact.program.is_motion[1] = contact.program.is_motion[5] = 1;
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
    const Eigen::MatrixXd all = factor.candidate_flexibility();
    const Eigen::VectorXd free = factor.solve(-R);
    const auto poses = contact.model.poses(contact.state.q);
    for (int i = 0; i < 6; ++i)
      if (in_contact(contact.state.nodes[i].state)) active.push_back(i);
    const Eigen::Index n = 2 * static_cast<Eigen::Index>(active.size());
    flexibility.resize(n, n);
    input.free_increment.resize(n);
    input.offset.resize(n);
    for (std::size_t a = 0; a < active.size(); ++a) {
      const int i = active[a], dof = 2 * contact.model.candidates[i];
      nodes.push_back(linearize_node(contact.model, contact.state.nodes[i], i, poses,
                                     Vector<2>(R.segment<2>(dof)), GeometricTerms::COMPLETE));
      input.offset.segment<2>(2 * a) = nodes.back().point.x - spring.body.position(u, dof / 2);
      input.free_increment.segment<2>(2 * a) = free.segment<2>(dof);
      for (std::size_t b = 0; b < active.size(); ++b)
        flexibility.block<2, 2>(2 * a, 2 * b) = all.block<2, 2>(2 * i, 2 * active[b]);
    }
    input.nodes = &nodes;
    input.flexibility = &flexibility;
  }
  ContactBlockSolution<2> solve_block() const {
    return solve_contact_block(contact.model, contact.program, contact.state.q, input);
  }
};

template <class Solver> void compare_with(Scene& scene) {
  Condensation<2> condensation(scene.contact.model, scene.spring.body);
  const auto& system = condensation.condense(scene.spring.tangent(scene.u), scene.contact.state,
                                             scene.contact.program, scene.contact.program, scene.u, scene.R,
                                             GeometricTerms::COMPLETE, RightHandSide::TOTAL, false);
  Solver solver;
  ASSERT_EQ(solver.factorize(view(system)), FactorStatus::OK);
  const auto step = condensation.expand(solver.solve(system.rhs));
  const auto block = scene.solve_block();
  ASSERT_FALSE(block.singular);
  expect_close(block.dq, step.dq, step.dq.norm(), 1e-11, "dq");
  const Eigen::VectorXd force = scene.R + scene.spring.tangent(scene.u).multiply(step.du);
  Eigen::VectorXd ds(block.ds.size()), F(block.F.size());
  for (std::size_t a = 0; a < scene.active.size(); ++a) {
    ds[static_cast<Eigen::Index>(a)] = step.ds[scene.active[a]];
    F.segment<2>(2 * a) = force.segment<2>(2 * scene.contact.model.candidates[scene.active[a]]);
  }
  expect_close(block.ds, ds, ds.norm(), 1e-11, "ds");
  expect_close(block.F, F, F.norm(), 1e-11, "F");
  EXPECT_GE(ds.norm(), 1e-3);
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
    const double ds = block.ds[static_cast<Eigen::Index>(a)];
    force.segment<3>(3 * node.tool) += node.point.x_q.transpose() * F + node.geo_qq * dq + node.geo_qs * ds;
    if (node.sliding) {
      EXPECT_NEAR(node.tau.dot(F) + node.constant + node.geo_ss * ds + node.geo_sq.dot(dq), 0, 1e-13);
    }
  }
  for (int k : {0, 2, 3, 4}) EXPECT_NEAR(force[k], scene.contact.program.value[k], 1e-12) << k;
  EXPECT_NEAR(block.dq[1], 0.02, 1e-15);
  EXPECT_NEAR(block.dq[5], -0.01, 1e-15);
}

// A frictionless roller under torque: nothing resists its rotation, and the block names the coordinate.
TEST(ContactBlock, NamesTheCoordinateWithoutSupport) {
  Scene scene(0);
  scene.contact.program.is_motion[3] = 1; // or nothing would resist the line along itself
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

TEST(ContactBlock, IndefiniteFlexibilityIsSingular) {
  Scene scene(0.3);
  scene.flexibility(0, 0) = -1;
  const auto block = scene.solve_block();
  EXPECT_TRUE(block.singular);
  EXPECT_EQ(block.weakest_coordinate, -1);
}

// A tool that touches nothing has no row at all: its first coordinate under force is named.
TEST(ContactBlock, ToolWithoutContact) {
  Scene scene(0.3);
  for (auto& node : scene.nodes) node = scene.nodes[0];
  const auto block = scene.solve_block();
  EXPECT_TRUE(block.singular);
  EXPECT_EQ(block.weakest_coordinate, 3);
}

TEST(Friction, LawsAndBadInput) {
  EXPECT_TRUE(make_coulomb(0)->frictionless());
  EXPECT_EQ(make_coulomb(0)->limit(5, 1), 0);
  EXPECT_EQ(make_coulomb(0)->slope(5, 1), 0);
  EXPECT_FALSE(make_coulomb(0.2)->frictionless());
  EXPECT_DOUBLE_EQ(make_coulomb(0.2)->limit(5, 1), 1);
  EXPECT_DOUBLE_EQ(make_coulomb(0.2)->slope(5, 1), 0.2);
  expect_invalid([] { make_coulomb(-0.3); }, "CoulombFriction: mu = -0.3, expected mu >= 0");
  expect_invalid([] { make_coulomb(std::nan("")); }, "CoulombFriction: mu = nan, expected mu >= 0");
}

// A stiffness added to the tangent before it is factorized, and taken off in the block, leaves no trace: also on
// a node that is not in contact.
TEST(ContactBlock, ShiftLeavesNoTrace) {
  for (const double mu : {0., 0.3}) {
    Scene scene(mu);
    const auto plain = scene.solve_block();
    NodeBlockMatrix<2> K = scene.spring.tangent(scene.u);
    const std::vector<int> shifted = {0, 2, 4}; // candidates; 2 is loose
    std::vector<int> active = {0, 1, 2, 3, 4};
    Eigen::VectorXd shift = Eigen::VectorXd::Zero(10);
    for (const int i : shifted) {
      const int node = scene.contact.model.candidates[i];
      for (int c = 0; c < 2; ++c) {
        if (scene.spring.body.fixed[2 * node + c]) continue;
        shift[2 * i + c] = 1.5 + i + c;
        K.block(K.find(node, node))[3 * c] += shift[2 * i + c];
      }
    }
    SchurFactor<2> factor;
    factor.analyze(K, scene.spring.body.fixed, scene.contact.model.candidates);
    ASSERT_EQ(factor.factorize(K), FactorStatus::OK);
    const Eigen::MatrixXd all = factor.candidate_flexibility();
    const Eigen::VectorXd free = factor.solve(-scene.R);
    std::vector<NodeLinearization<2>> nodes;
    Eigen::MatrixXd flexibility(10, 10);
    ContactBlockInput<2> input;
    input.offset = input.free_increment = Eigen::VectorXd::Zero(10);
    for (int a = 0, known = 0; a < 5; ++a) {
      if (a == 2) {
        nodes.emplace_back();
        nodes.back().loose = true;
      } else {
        nodes.push_back(scene.nodes[known]);
        input.offset.segment<2>(2 * a) = scene.input.offset.segment<2>(2 * known++);
      }
      input.free_increment.segment<2>(2 * a) = free.segment<2>(2 * scene.contact.model.candidates[a]);
      for (int b = 0; b < 5; ++b) flexibility.block<2, 2>(2 * a, 2 * b) = all.block<2, 2>(2 * a, 2 * b);
    }
    input.nodes = &nodes;
    input.flexibility = &flexibility;
    input.shift = shift;
    const auto with =
        solve_contact_block(scene.contact.model, scene.contact.program, scene.contact.state.q, input);
    ASSERT_FALSE(with.singular);
    EXPECT_LT((with.dq - plain.dq).norm(), 1e-11 * plain.dq.norm());
    for (int a = 0, known = 0; a < 5; ++a) {
      if (a == 2) {
        EXPECT_LT(with.F.segment<2>(4).norm(), 1e-11 * plain.F.norm()) << "no force on a loose node";
        continue;
      }
      EXPECT_LT((with.F.segment<2>(2 * a) - plain.F.segment<2>(2 * known)).norm(), 1e-10 * plain.F.norm());
      EXPECT_NEAR(with.ds[a], plain.ds[known], 1e-11);
      ++known;
    }
  }
}
