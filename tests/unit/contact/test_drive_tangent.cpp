// Forces by formula and coordinates that follow others in the condensed tangent, against finite differences of a residual
// that is written down by hand; dense block against sparse system; virtual work.
#include "contact/balance.hpp"
#include "solver/bordered_solver.hpp"
#include "solver/unsymmetric_solver.hpp"
#include "unit/contact/driven_sample.hpp"

using namespace burnish;
using namespace burnish::test;

TEST(DriveTangent, EveryBlockAgainstFiniteDifferences) {
  for (const double mu : {0., 0.3})
    for (const bool coupled : {false, true})
      for (const bool formulas : {false, true}) {
        SCOPED_TRACE(testing::Message()
                     << "mu " << mu << ", coupled " << coupled << ", formulas " << formulas);
        Driven driven(mu, coupled, formulas);
        expect_blocks(driven.tangent(), driven.expected(), driven.kinds(), 1e-9);
      }
}

// The test above must see stiffness and relations: without them the block of the coordinates is far off.
TEST(DriveTangent, StiffnessAndRelationsMatter) {
  Driven driven(0.3);
  const Eigen::MatrixXd expected = driven.expected();
  const auto error = [&](Driven& other) {
    return block_error(other.tangent(), expected, driven.kinds(), Unknown::COORDINATE, Unknown::COORDINATE);
  };
  Driven forces(0.3, true, false), alone(0.3, false, true);
  EXPECT_GE(error(forces), 1e-1);
  EXPECT_GE(error(alone), 1e-2);
  EXPECT_LE(error(driven), 1e-9);
}

// The right-hand side is the negative residual, and that of coordinates that follow vanishes.
TEST(DriveTangent, RightHandSide) {
  for (const double mu : {0., 0.3}) {
    Driven driven(mu);
    Condensation<2> condensation(driven.contact.model, driven.spring.body);
    const Eigen::VectorXd rhs = driven.system(condensation).rhs,
                          r = driven.residual(Eigen::VectorXd::Zero(30));
    for (const int k : {R_, PHI, THETA, X}) EXPECT_NEAR(rhs[24 + k], -r[24 + k], 1e-12 * r.norm()) << k;
    EXPECT_EQ(rhs[24 + Y], 0);
    EXPECT_EQ(rhs[24 + ANGLE], 0);
  }
}

// A coordinate under motion takes its columns, with the slopes of the forces, to the other side.
TEST(DriveTangent, MotionMovesTheColumns) {
  Driven driven(0.3), held(0.3);
  held.contact.prescribed.is_motion[THETA] = 1;
  held.contact.prescribed.value[THETA] = held.contact.state.q[THETA] + 0.05;
  Condensation<2> a(driven.contact.model, driven.spring.body), b(held.contact.model, held.spring.body);
  const CondensedSystem free = driven.system(a), given = held.system(b);
  const Eigen::VectorXd expected = free.rhs - 0.05 * dense(free).col(24 + THETA);
  for (const int k : {R_, PHI, X}) EXPECT_NEAR(given.rhs[24 + k], expected[24 + k], 1e-11) << k;
  UnsymmetricSolver solver;
  ASSERT_EQ(solver.factorize(view(given)), FactorStatus::OK);
  const auto step = b.expand(solver.solve(given.rhs));
  EXPECT_NEAR(step.dq[THETA], 0.05, 1e-12);
  EXPECT_NEAR(step.dq[ANGLE], -0.1, 1e-12) << "follows";
}

TEST(DriveTangent, BorderedSolverAgrees) {
  Driven driven(0.3, true, false);
  auto& formula = driven.contact.prescribed.formula; // stiff springs: positive definite but for friction
  formula.resize(6);
  const std::vector<std::string> names{"r", "phi", "theta"};
  for (const int k : {R_, PHI, THETA})
    formula[k] = force_formula("circle", names[k], "-80*" + names[k] + " - 3*r", names, {});
  formula[X] = force_formula("line", "x", "-80*x + y", {"x", "y", "angle"}, {});
  Condensation<2> condensation(driven.contact.model, driven.spring.body);
  const CondensedSystem system = driven.system(condensation);
  BorderedSolver bordered;
  UnsymmetricSolver unsymmetric;
  ASSERT_EQ(bordered.factorize(view(system)), FactorStatus::OK);
  ASSERT_EQ(unsymmetric.factorize(view(system)), FactorStatus::OK);
  const Eigen::VectorXd x = unsymmetric.solve(system.rhs);
  expect_close(Eigen::VectorXd(bordered.solve(system.rhs)), x, x.norm(), 1e-11, "solution");
}

TEST(DriveTangent, SymmetricWhereTheForcesAre) {
  Driven driven(0, true, false);
  const Eigen::MatrixXd K = driven.tangent();
  EXPECT_LE((K - K.transpose()).norm(), 1e-13 * K.norm()) << "relations keep the symmetry";
  auto& formula = driven.contact.prescribed.formula;
  formula.resize(6);
  formula[R_] = force_formula("circle", "r", "-4*r^3 - 2*phi", {"r", "phi", "theta"}, {});
  formula[PHI] = force_formula("circle", "phi", "-phi - 2*r", {"r", "phi", "theta"}, {});
  const Eigen::MatrixXd full = driven.tangent(), half = driven.tangent(true);
  EXPECT_LE((full - half).norm(), 1e-13 * full.norm());
  EXPECT_NEAR(full(24 + R_, 24 + PHI) - K(24 + R_, 24 + PHI), 2, 1e-12);
  formula[PHI] = force_formula("circle", "phi", "-phi - 3*r", {"r", "phi", "theta"}, {});
  expect_invalid(
      [&] { driven.tangent(true); },
      "condense: symmetric storage needs symmetric forces, but that of coordinate \"phi\" of tool "
      "\"circle\" changes by -3 with coordinate \"r\" of tool \"circle\", the other way round by -2");
}

// What a coordinate bears is the work of all contact forces over its change, what follows it moving along.
TEST(Coupling, VirtualWork) {
  Driven driven(0.3);
  const auto& model = driven.contact.model;
  const Eigen::VectorXd R = driven.spring.force(driven.u);
  const Balance found = balance<2>(
      {model, driven.spring.body, driven.contact.state, driven.contact.prescribed, driven.u, R, {}});
  for (const int k : {R_, PHI, THETA, X}) {
    const auto work = [&](double change) {
      Eigen::VectorXd q = driven.contact.state.q;
      q[k] += change;
      follow(model, q);
      const auto poses = model.poses(q);
      double sum = 0;
      for (std::size_t i = 0; i < driven.contact.state.nodes.size(); ++i) {
        const auto& node = driven.contact.state.nodes[i];
        if (in_contact(node.state))
          sum += R.segment<2>(2 * model.candidates[i])
                     .dot(model.tools[node.tool]->position(poses[node.tool], node.place));
      }
      return sum;
    };
    EXPECT_NEAR(found.generalized_force[k], finite_difference(work, 0, 2e-3), 1e-9) << k;
  }
  EXPECT_GE(std::abs(found.generalized_force[Y]), 1e-3) << "that of a coordinate that follows is its own";
}

TEST(DrivingForce, ValueSlopeAndSupport) {
  Driven driven(0.3);
  const auto& prescribed = driven.contact.prescribed;
  const Eigen::VectorXd q = driven.contact.state.q;
  const DrivingForce drive = driving_force(driven.contact.model, prescribed, q);
  EXPECT_NEAR(drive.value[R_], -4 * std::pow(q[R_], 3) + q[PHI] * q[THETA] - 0.7, 1e-14);
  EXPECT_NEAR(drive.slope(R_, R_), -12 * q[R_] * q[R_], 1e-13);
  EXPECT_EQ(drive.slope(X, Y), 0) << "passed on to what y follows";
  EXPECT_NEAR(drive.slope(X, THETA), -3 * q[X] * 0.3 * std::sin(2 * q[R_]), 1e-14);
  const std::vector<char> held = held_by_drive(drive, prescribed);
  EXPECT_EQ(held[R_], 1);
  EXPECT_EQ(held[PHI], 1);
  EXPECT_EQ(held[THETA], 0);
}

// A kink has a slope on the side where the coordinate grows; a pole has none.
TEST(CoordinateFormula, KinksAndPoles) {
  const CoordinateFormula kink("force", "-3*y - 2*abs(y)", {{"x", "y"}, {}}, true),
      pole("force", "1/y", {{"x", "y"}, {}}, false);
  const double zero[] = {1, 0};
  EXPECT_EQ(kink.arguments(), std::vector<int>{1});
  EXPECT_NEAR(kink.first(0, zero, 2), -5, 1e-14);
  EXPECT_NEAR(kink.second(0, 0, zero, 2), 0, 1e-14);
  EXPECT_THROW(pole.value(zero), FormulaDomainError);
}

TEST(Coupling, NamesWithSpacesAndPrefixes) {
  SpringContact contact;
  contact.add(make_tool("tool 1", Shape::CIRCLE, Frame::CARTESIAN), 0);
  contact.add(make_tool("1-b", Shape::CIRCLE, Frame::CARTESIAN), 0);
  const Coupling made = make_coupling(contact.model, "1-b.y", "2*tool 1.y+0.5*tool 1.angle^2-1.5e0*1-b.x");
  EXPECT_EQ(made.dependent, 4);
  EXPECT_EQ(made.formula->arguments(), (std::vector<int>{1, 2, 3}));
  const double q[] = {9, 3, 2, 7, 9, 9};
  EXPECT_NEAR(made.formula->value(q), 6 + 2 - 10.5, 1e-14);
}
