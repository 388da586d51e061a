// A workpiece in space with J2: its tangent, a user-defined law beside it, damage and events.
#include "material/j2/law.hpp"
#include "material/user_law.hpp"
#include "run/run_body.hpp"
#include "support/tetrahedra.hpp"
#include "unit/material/in_space.hpp"
#include "unit/material/j2/law_point.hpp"
#include "workpiece/point_fields.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

LawInput kinematic(const char* rate) {
  LawInput input{with_example_elasticity({{"sigY", 1.93e8}, {"H", 9.62e8}, {"C", 8e9}, {"gamma", 60}})};
  input.backstress = "armstrongfrederick";
  input.rate = rate;
  return input;
}

UpdateOptions single() {
  UpdateOptions options;
  options.update = StressUpdate::SINGLE;
  return options;
}

/// Strains and rotations of about `size` that change over the body.
Eigen::VectorXd bent(const Discretization<3>& mesh, double size) {
  Eigen::VectorXd u(mesh.num_dofs());
  for (int a = 0; a < mesh.num_nodes; ++a) {
    const Vector<3> X = mesh.node(a);
    u.segment<3>(3 * a) =
        size * Vector<3>(X[0] - 2 * X[1] + X[1] * X[2], X[0] * X[0] - X[2], X[1] + 0.5 * X[2] * X[0]);
  }
  return u;
}

Eigen::MatrixXd dense(const NodeBlockMatrix<3>& matrix) {
  Eigen::MatrixXd K(matrix.size(), matrix.size());
  for (int c = 0; c < matrix.size(); ++c) K.col(c) = matrix.multiply(Eigen::VectorXd::Unit(matrix.size(), c));
  return K;
}

Eigen::MatrixXd exact_tangent(const Workpiece<3>& body) {
  NodeBlockMatrix<3> K = body.pattern();
  body.tangent(K, TangentKind::CONSISTENT);
  EXPECT_LE((dense(K) - dense(K).transpose()).norm(), 1e-14 * dense(K).norm());
  body.add_antisymmetric_tangent(K, TangentKind::CONSISTENT);
  return dense(K);
}

void step(Workpiece<3>& body, const Eigen::VectorXd& u, int iteration = 0) {
  ASSERT_EQ(body.update(u, 1, iteration).status, UpdateStatus::OK);
}

// A body with the core's law, and one of the same mesh whose law is user-defined.
struct Pair {
  Workpiece<3> core, user;
  explicit Pair(int nodes)
      : core(two_tetrahedra(nodes), j2_law<3>(example_material()), single()),
        user(two_tetrahedra(nodes), std::make_shared<UserLaw<3>>(), single()) {}
  void move(double size) {
    const Eigen::VectorXd u = bent(core.discretization(), size);
    step(core, u);
    step(user, u);
  }
  Eigen::VectorXd component(const std::vector<double>& all, int component, int size) const {
    Eigen::VectorXd v(core.discretization().num_points());
    for (Eigen::Index p = 0; p < v.size(); ++p) v[p] = all[p * size + component];
    return v;
  }
  void give_stress() {
    for (int c = 0; c < 6; ++c) user.given("give").stress(c, component(core.state().stress, c, 6));
    user.given("give").internal("plastic_strain_eq", 0, internal_field(core, "plastic_strain_eq"));
  }
  void accept() {
    core.accept();
    user.accept();
  }
};

double difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) { return (a - b).norm() / a.norm(); }

} // namespace

TEST(J2InSpace, TangentIsTheDerivativeOfTheForce) {
  for (int nodes : {4, 10})
    for (const char* rate : {"jaumann", "greennaghdi", "logarithmic"}) {
      SCOPED_TRACE(std::string(rate) + ", " + std::to_string(nodes) + " nodes");
      Workpiece<3> body(two_tetrahedra(nodes), make_law<3>(kinematic(rate), "test"));
      for (const double size : {0.01, 0.02}) {
        step(body, bent(body.discretization(), size));
        body.accept();
      }
      const Eigen::VectorXd u = bent(body.discretization(), 0.027);
      step(body, u);
      EXPECT_GT(internal_field(body, "plastic_strain_eq").minCoeff(), 1e-3);
      const Eigen::MatrixXd K = exact_tangent(body);
      Eigen::MatrixXd measured(u.size(), u.size());
      for (int c = 0; c < u.size(); ++c)
        measured.col(c) = finite_difference(
            [&](double t) {
              step(body, u + t * Eigen::VectorXd::Unit(u.size(), c), FREEZE_ITERATION);
              return body.internal_force();
            },
            0, 1e-6);
      EXPECT_LE(difference(measured, K), 1e-7);
    }
}

TEST(J2InSpace, AUserDefinedLawByNineGradientsAndSixStresses) {
  for (int nodes : {4, 10}) {
    Pair pair(nodes);
    for (const double size : {0.002, 0.01, 0.014}) {
      pair.move(size);
      pair.give_stress();
      const std::vector<double> A = moduli_field(pair.core, TangentKind::CONSISTENT);
      for (int i = 0; i < 9; ++i)
        for (int j = i; j < 9; ++j) pair.user.given("give").moduli(i, j, pair.component(A, 9 * i + j, 81));
      EXPECT_LE(difference(pair.core.internal_force(), pair.user.internal_force()), 1e-14);
      NodeBlockMatrix<3> K = pair.core.pattern(), L = K;
      pair.core.tangent(K, TangentKind::CONSISTENT);
      pair.user.tangent(L, TangentKind::CONSISTENT);
      EXPECT_LE(difference(dense(K), dense(L)), 1e-14);
      EXPECT_EQ(pair.core.state().strain_increment, pair.user.state().strain_increment);
      EXPECT_EQ(pair.core.state().plastic, pair.user.state().plastic);
      pair.accept();
    }
    EXPECT_GT(internal_field(pair.user, "plastic_strain_eq").maxCoeff(), 0.003);
  }
}

TEST(J2InSpace, AUserDefinedLawByPiolaStress) {
  Pair pair(10);
  pair.move(0.01);
  const std::vector<double> P = piola_field(pair.core);
  for (int c = 0; c < 9; ++c) {
    expect_invalid([&] { pair.user.internal_force(); },
                   c == 0 ? "component xx of the stress" : "of the first Piola stress");
    pair.user.given("give").piola(c, pair.component(P, c, 9));
  }
  EXPECT_LE(difference(pair.core.internal_force(), pair.user.internal_force()), 1e-13);
  const std::vector<double> P_xy = P;
  pair.move(0.01);
  for (int c = 0; c < 8; ++c) pair.user.given("give").piola(c, pair.component(P, c, 9));
  Eigen::VectorXd wrong = pair.component(P, 1, 9);
  wrong.array() += 1e7;
  pair.user.given("give").piola(8, pair.component(P, 8, 9));
  expect_invalid([&] { pair.user.given("give").piola(1, wrong); }, "P F' is not symmetric at point 0");
}

// d tau/dy as in METHOD.md (1.32): the six strains and the three spins of the step.
TEST(J2InSpace, AUserDefinedLawByItsDerivativeByTheIncrements) {
  Pair pair(4);
  for (const double size : {0.01, 0.014}) {
    if (size > 0.01) pair.accept();
    pair.move(size);
    pair.give_stress();
    const PointScheme scheme{StressUpdate::SINGLE, 1.5, 1, 0};
    std::vector<StressByIncrement<3>> D;
    for (int p = 0; p < pair.core.discretization().num_points(); ++p) {
      const PointStep<3> one = pair.core.point_step(p);
      const StepKinematics<3> kin = step_kinematics(Gradient<3>(one.old.F), one.F, one.options.strain_frame);
      const J2Start<3> start{one.old.stress, one.old.internal[0], one.old.strain_increment, one.old.plastic};
      D.push_back(
          consistent_moduli<3>(example_material(), scheme, start, kin,
                               elastic_trial<3>(example_material().elastic, kin, Stress<3>(one.old.stress))));
    }
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 9; ++j) {
        Eigen::VectorXd values(static_cast<Eigen::Index>(D.size()));
        for (Eigen::Index p = 0; p < values.size(); ++p) values[p] = D[p](i, j);
        pair.user.given("give").jacobian(i, j, values);
      }
    EXPECT_LE(difference(exact_tangent(pair.core), exact_tangent(pair.user)), 1e-13);
  }
}

TEST(J2InSpace, DamageBeginsAfterAnEventOfAPoint) {
  RunBody<3> run(std::make_unique<Workpiece<3>>(two_tetrahedra(4), j2_law<3>(example_material())));
  Workpiece<3>& body = run.workpiece();
  run.user().add(body, "crumble", "ep - 0.01", {});
  run.damage().damage(body, run.user(), "crumble", 0.1, 2);
  const double stretches[] = {0.005, 0.02, 0.021, 0.022, 0.023}, expected[] = {1, 1, 0.55, 0.1, 0.1};
  for (int k = 0; k < 5; ++k) {
    Tensor<3> F = turn_about({1, 2, -1}, 0.1 * k);
    F *= Tensor<3>(Vector<3>(1 + stretches[k], 1 - 0.4 * stretches[k], 1 - 0.4 * stretches[k]).asDiagonal());
    step(body, homogeneous(body.discretization(), F));
    const Eigen::VectorXd whole = body.internal_force();
    run.accept();
    for (int p = 0; p < 2; ++p)
      EXPECT_NEAR(integrity_of(body.state(), p), expected[k], 1e-14) << "step " << k;
    if (k > 1) {
      const double carried = carried_piola(body.state(), 0, false).norm();
      const PointState<3> at = point_state(body.state(), 0);
      EXPECT_NEAR(carried / first_piola(Stress<3>(at.stress), inverse(Gradient<3>(at.F))).norm(), expected[k],
                  1e-13);
      EXPECT_GT(whole.norm(), 0);
    }
  }
  EXPECT_EQ(run.user().number("crumble"), 2);
}

TEST(J2InSpace, YieldEventsAreThoseOfThePlane) {
  Workpiece<3> body(two_tetrahedra(4), j2_law<3>(example_material()));
  const Tensor<3> Q = turn_about({1, 2, -1}, 1.1);
  const Gradient<2> F = gradient(tensor(1.01, 0.004, 0, 0.99));
  AnyLawPoint flat({with_example_elasticity({{"sigY", 1.93e8}, {"H", 9.62e8}})});
  const double expected = flat.law->yield_fraction(flat.step(F), 1, 0);
  step(body, homogeneous(body.discretization(), mesh_part<3>(in_space(F, Q))));
  const auto events = element_events<3>(body, 0);
  ASSERT_EQ(events.size(), 2u);
  EXPECT_NEAR(first_fraction(events), expected, 1e-12);
}
