// The condensed system as a whole: right-hand sides, expansion, pattern, convergence of Newton's method, bad
// input.
#include "contact/slip_motion.hpp"
#include "solver/unsymmetric_solver.hpp"
#include "unit/contact/condensed_residual.hpp"
#include "unit/contact/spring_body.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// A polar roller with friction; one node slides, one sticks; r under force, phi moved, theta under force.
struct Scene {
  SpringBody spring{0.3};
  SpringContact contact;
  Eigen::VectorXd u = 0.05 * Eigen::VectorXd::LinSpaced(24, -1, 2).array().sin();
  Condensation<2> condensation{contact.model, spring.body};
  PrescribedValues before;
  explicit Scene(double mu = 0.3) {
    contact.add(make_tool("roller", Shape::CIRCLE, Frame::POLAR), mu);
    contact.touch(1, 0, 0.3, mu > 0 ? -1 : 0, true);
    contact.touch(3, 0, 0.9, 0, false);
    spring.body.fixed[0] = spring.body.fixed[21] = 1;
    contact.prescribed.value = Vector<3>(0.04, contact.state.q[1] + 0.05, -0.03);
    contact.prescribed.is_motion[1] = 1;
    before = contact.prescribed;
    before.value = Vector<3>(0.01, contact.state.q[1], -0.02);
    contact.settle(spring.body, u);
  }
  const CondensedSystem& condense(RightHandSide right, bool half = false) {
    return condensation.condense({spring.tangent(u), contact.state, contact.prescribed, before, u,
                                  spring.force(u), GeometricTerms::COMPLETE, right, half});
  }
  Eigen::VectorXd residual() const { // of the unknowns that are not given
    const auto force = [this](const Eigen::VectorXd& x) { return spring.force(x); };
    Eigen::VectorXd r =
        condensed_residual(contact.model, spring.body, force, Eigen::VectorXd::Zero(27), contact.state, u);
    r.tail<3>() -= contact.prescribed.value;
    for (const auto i :
         of_kind(unknowns(contact.model, contact.state, contact.prescribed, spring.body), Unknown::GIVEN))
      r[i] = 0;
    return r;
  }
  void advance() {
    const auto& system = condense(RightHandSide::TOTAL);
    UnsymmetricSolver solver;
    ASSERT_EQ(solver.factorize(view(system)), FactorStatus::OK);
    const auto step = condensation.expand(solver.solve(system.rhs));
    u += step.du;
    move_by(contact.model, step, contact.state);
  }
};

} // namespace

// Nodes on the tool and no motion: the total right-hand side is minus the condensed residual.
TEST(Condensation, TotalRightHandSideIsMinusTheResidual) {
  Scene scene;
  scene.contact.prescribed.value[1] = scene.contact.state.q[1];
  const Eigen::VectorXd rhs = scene.condense(RightHandSide::TOTAL).rhs;
  EXPECT_LE((rhs + scene.residual()).norm(), 1e-14 * rhs.norm());
}

// The article's pure rates: increments of forces and motions, no residual. Nothing prescribed, nothing moves.
TEST(Condensation, RatesKnowIncrementsOnly) {
  Scene scene;
  scene.contact.prescribed.value[1] = scene.contact.state.q[1];
  const Eigen::VectorXd rhs = scene.condense(RightHandSide::RATES).rhs;
  EXPECT_NEAR(rhs[24], 0.03, 1e-14);
  EXPECT_EQ(rhs[25], 0);
  EXPECT_NEAR(rhs[26], -0.01, 1e-14);
  EXPECT_LE(rhs.head(24).cwiseAbs().maxCoeff(), 1e-14);
}

// A moved coordinate acts as if its column stood in the matrix.
TEST(Condensation, MotionIsItsColumnOnTheRight) {
  Scene scene;
  const Eigen::VectorXd moved = scene.condense(RightHandSide::TOTAL).rhs;
  Scene held;
  held.contact.prescribed.value[1] = held.contact.state.q[1];
  const Eigen::VectorXd still = held.condense(RightHandSide::TOTAL).rhs;
  Scene free;
  free.contact.prescribed.is_motion[1] = 0;
  const Eigen::MatrixXd K = dense(free.condense(RightHandSide::TOTAL));
  Eigen::VectorXd column = 0.05 * K.col(25);
  column[25] = 0;
  Eigen::VectorXd difference = still - moved;
  difference[25] = 0;
  EXPECT_LE((difference - column).norm(), 1e-13 * column.norm());
  EXPECT_GE(column.norm(), 1e-3);
}

// Complete terms: Newton's method converges quadratically and ends in equilibrium with every node in place.
TEST(Condensation, NewtonConvergesQuadratically) {
  Scene scene;
  std::vector<double> history;
  for (int k = 0; k < 8; ++k) {
    scene.advance();
    Eigen::VectorXd on_tool = scene.u;
    scene.contact.place(scene.spring.body, on_tool);
    history.push_back(scene.residual().norm() + (on_tool - scene.u).norm());
  }
  EXPECT_LE(history.back(), 1e-13);
  for (std::size_t k = 1; k < history.size(); ++k)
    if (history[k - 1] < 0.1 && history[k] > 1e-13) {
      EXPECT_LE(history[k], 5 * history[k - 1] * history[k - 1]) << "iteration " << k;
    }
  EXPECT_NEAR(scene.contact.state.q[1], scene.contact.prescribed.value[1], 1e-15);
}

TEST(Condensation, ExpandSeparatesNodesSlipsAndCoordinates) {
  Scene scene;
  const auto& system = scene.condense(RightHandSide::TOTAL);
  UnsymmetricSolver solver;
  ASSERT_EQ(solver.factorize(view(system)), FactorStatus::OK);
  const Eigen::VectorXd z = solver.solve(system.rhs);
  const auto step = scene.condensation.expand(z);
  const int sliding = 2 * 4, sticking = 2 * 6; // mesh nodes of candidates 1 and 3
  EXPECT_EQ(step.slip(0, 1), z[sliding]);
  EXPECT_EQ(step.slip(0, 3), 0);
  EXPECT_NEAR(step.dq[1], 0.05, 1e-15);
  EXPECT_EQ(step.dq[0], z[24]);
  EXPECT_EQ(step.du[0], 0) << "fixed";
  EXPECT_EQ(step.du[2 * 10 + 1], 0) << "fixed";
  EXPECT_EQ(step.du[5], z[5]) << "free";
  const auto& state = scene.contact.state;
  const auto p = scene.contact.model.tools[0]->point(state.q, state.nodes[3].place);
  EXPECT_LE((step.du.segment<2>(sticking) - p.x_q * step.dq).norm(), 1e-14);
  const auto slide = scene.contact.model.tools[0]->point(state.q, state.nodes[1].place);
  EXPECT_LE((step.du.segment<2>(sliding) - slide.x_q * step.dq - slide.E * step.slip.col(1)).norm(), 1e-14);
}

TEST(Condensation, PatternStaysWhenStatesChange) {
  Scene scene;
  const CondensedSystem first = scene.condense(RightHandSide::TOTAL);
  scene.contact.touch(0, 0, 0.1, 1, true);
  scene.contact.state.nodes[3] = {};
  const CondensedSystem& second = scene.condense(RightHandSide::TOTAL);
  EXPECT_EQ(first.row_start, second.row_start);
  EXPECT_EQ(first.col, second.col);
  EXPECT_NE(first.value, second.value);
}

TEST(Condensation, BadInput) {
  Scene scene;
  NodeBlockMatrix<2> small = pattern_from_elements<2>(3, 3, {0, 1, 2});
  const auto condense = [&](const NodeBlockMatrix<2>& K, GeometricTerms terms, bool half) {
    scene.condensation.condense({K, scene.contact.state, scene.contact.prescribed, scene.before, scene.u,
                                 scene.spring.force(scene.u), terms, RightHandSide::TOTAL, half});
  };
  expect_invalid([&] { condense(small, GeometricTerms::COMPLETE, false); },
                 "condense: size of K = 6, expected number of dofs of the contact's space");
  const auto& K = scene.spring.tangent(scene.u);
  expect_invalid([&] { condense(K, GeometricTerms::COMPLETE, true); },
                 "condense: symmetric storage needs a contact without friction");
  Scene smooth(0);
  expect_invalid(
      [&] {
        smooth.condensation.condense(
            {smooth.spring.tangent(smooth.u), smooth.contact.state, smooth.contact.prescribed, smooth.before,
             smooth.u, smooth.spring.force(smooth.u), GeometricTerms::ARTICLE, RightHandSide::TOTAL, true});
      },
      "condense: the article's terms are not symmetric");
  expect_invalid([&] { scene.condensation.expand(Eigen::VectorXd::Zero(27)); },
                 "expand: size of the solution = 27, expected the size of the last condensed matrix");
  scene.condense(RightHandSide::TOTAL);
  Eigen::VectorXd z = Eigen::VectorXd::Zero(27);
  z[3] = std::nan("");
  expect_invalid([&] { scene.condensation.expand(z); }, "expand: the solution contains NaN or Inf");
}
