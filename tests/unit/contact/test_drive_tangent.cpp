// Forces by formula and coordinates that follow others in the condensed tangent, against finite differences of a residual
// that is written down by hand; dense block against sparse system; virtual work.
#include "contact/balance.hpp"
#include "contact/coupling.hpp"
#include "contact/driving_force.hpp"
#include "solver/bordered_solver.hpp"
#include "solver/unsymmetric_solver.hpp"
#include "unit/contact/condensed_residual.hpp"
#include "unit/contact/spring_body.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

// q = r, phi, theta of the circle; x, y, angle of the line.
enum { R_, PHI, THETA, X, Y, ANGLE };

/// Five nodes on a circle and a line; y and angle of the line follow r and theta of the circle.
struct Driven {
  SpringBody spring{0.3};
  SpringContact contact;
  Eigen::VectorXd u = 0.2 * Eigen::VectorXd::LinSpaced(24, -1, 2).array().cos();

  explicit Driven(double mu, bool coupled = true, bool formulas = true) {
    contact.add(make_tool("circle", Shape::CIRCLE, Frame::POLAR), mu);
    contact.add(make_tool("line", Shape::SEGMENT, Frame::CARTESIAN), mu / 2);
    const double sign = mu > 0 ? 1 : 0;
    contact.touch(0, 0, 0.2, sign, true);
    contact.touch(1, 1, 0.6, -sign, true);
    contact.touch(2, 0, 0.8, 0, false);
    contact.touch(3, 1, 1.9, 0, false);
    contact.touch(4, 0, 1.9, -sign, true);
    if (coupled) {
      contact.model.couplings.push_back(
          make_coupling(contact.model, "line.y", "0.3*sin(2*circle.r)*circle.theta - 0.7"));
      contact.model.couplings.push_back(make_coupling(contact.model, "line.angle", "-2*circle.theta"));
    }
    follow(contact.model, contact.state.q);
    if (formulas) add_formulas();
    contact.prescribed.t = 0.7;
    contact.place(spring.body, u);
  }
  void add_formulas() {
    const std::vector<std::string> polar = contact.model.tools[0]->coordinates().names(),
                                   cartesian = contact.model.tools[1]->coordinates().names();
    auto& formula = contact.prescribed.formula;
    formula.resize(6);
    formula[R_] = force_formula("circle", "r", "-k*r^3 + phi*theta - t", polar, {{"k", 4}});
    formula[PHI] = force_formula("circle", "phi", "-2*phi + r*theta - r", polar, {});
    formula[X] = force_formula("line", "x", "-3*x*y - abs(x)", cartesian, {});
  }
  bool coupled() const { return !contact.model.couplings.empty(); }
  /// The residual with forces and relations put in by hand.
  Eigen::VectorXd residual(const Eigen::VectorXd& z) const {
    ContactState<2> state = contact.state;
    Eigen::VectorXd q = state.q + z.tail(6), change = z;
    if (coupled()) {
      q[Y] = 0.3 * std::sin(2 * q[R_]) * q[THETA] - 0.7;
      q[ANGLE] = -2 * q[THETA];
      change.tail(6) = q - state.q;
    }
    const auto force = [this](const Eigen::VectorXd& x) { return spring.force(x); };
    Eigen::VectorXd r = condensed_residual(contact.model, spring.body, force, change, state, u);
    auto Q = r.tail(6);
    if (coupled()) {
      Q[R_] += 0.6 * std::cos(2 * q[R_]) * q[THETA] * Q[Y];
      Q[THETA] += 0.3 * std::sin(2 * q[R_]) * Q[Y] - 2 * Q[ANGLE];
      Q[Y] = Q[ANGLE] = 0;
    }
    if (contact.prescribed.formula.empty()) return r;
    Q[R_] -= -4 * std::pow(q[R_], 3) + q[PHI] * q[THETA] - 0.7;
    Q[PHI] -= -2 * q[PHI] + q[R_] * q[THETA] - q[R_];
    Q[X] -= -3 * q[X] * q[Y] - std::abs(q[X]);
    return r;
  }
  std::vector<Unknown> kinds() const {
    auto kind = unknowns(contact.model, contact.state, contact.prescribed, spring.body);
    if (coupled()) kind[24 + Y] = kind[24 + ANGLE] = Unknown::GIVEN;
    return kind;
  }
  Eigen::MatrixXd expected() const {
    const auto kind = kinds();
    const auto n = static_cast<Eigen::Index>(kind.size());
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(n, n);
    for (Eigen::Index j = 0; j < n; ++j)
      if (kind[static_cast<std::size_t>(j)] != Unknown::GIVEN)
        J.col(j) =
            finite_difference([&](double t) { return residual(t * Eigen::VectorXd::Unit(n, j)); }, 0, 2e-3);
    return J;
  }
  CondensedSystem system(Condensation<2>& condensation, bool half = false) {
    return condensation.condense({spring.tangent(u), contact.state, contact.prescribed, contact.prescribed, u,
                                  spring.force(u), GeometricTerms::COMPLETE, RightHandSide::TOTAL, half});
  }
  Eigen::MatrixXd tangent(bool half = false) {
    Condensation<2> condensation(contact.model, spring.body);
    return dense(system(condensation, half));
  }
};

} // namespace

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
