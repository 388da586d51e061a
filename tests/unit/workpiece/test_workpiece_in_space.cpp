// A workpiece in space with a law of the test: state, assembly, events, fields.
#include "support/kirchhoff_law.hpp"
#include "support/tetrahedra.hpp"
#include "unit/finite_difference.hpp"
#include "workpiece/nodal_average.hpp"
#include "workpiece/point_events.hpp"
#include "workpiece/point_fields.hpp"
#include "workpiece/point_place.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

const double LAMBDA = 3, MU = 2;

struct Body {
  std::shared_ptr<KirchhoffLaw> law = std::make_shared<KirchhoffLaw>(LAMBDA, MU);
  Workpiece<3> body;
  explicit Body(int nodes) : body(two_tetrahedra(nodes), law) {}
  const Discretization<3>& mesh() const { return body.discretization(); }

  /// Strains and rotations of some tenths that change over the body.
  Eigen::VectorXd deformed() const {
    Eigen::VectorXd u(mesh().num_dofs());
    for (int a = 0; a < mesh().num_nodes; ++a) {
      const Vector<3> X = mesh().node(a);
      u.segment<3>(3 * a) =
          0.1 * Vector<3>(X[0] - 2 * X[1] + X[1] * X[2], X[0] * X[0] - X[2], X[1] + 0.5 * X[2] * X[0]);
    }
    return u;
  }
  void move_to(const Eigen::VectorXd& u) { ASSERT_EQ(body.update(u, 1, 0).status, UpdateStatus::OK); }
  double energy() const {
    return internal_field(body, "energy_density")
        .dot(Eigen::Map<const Eigen::VectorXd>(mesh().weight.data(), mesh().num_points()));
  }
};

Eigen::MatrixXd dense(const NodeBlockMatrix<3>& matrix) {
  Eigen::MatrixXd K(matrix.size(), matrix.size());
  for (int c = 0; c < matrix.size(); ++c) K.col(c) = matrix.multiply(Eigen::VectorXd::Unit(matrix.size(), c));
  return K;
}

} // namespace

TEST(WorkpieceInSpace, StartsUndeformed) {
  const Body b(10);
  EXPECT_EQ(b.body.state().F.size(), 8u * 9);
  EXPECT_EQ(b.body.state().stress.size(), 8u * 6);
  EXPECT_EQ(b.body.state().internal.size(), 8u * 7);
  EXPECT_EQ(b.body.internal_force(), Eigen::VectorXd::Zero(b.mesh().num_dofs()));
  double volume = 0;
  for (const double w : b.mesh().weight) volume += w;
  EXPECT_NEAR(volume, (Body(4).mesh().weight[0] + Body(4).mesh().weight[1]), 1e-14);
}

TEST(WorkpieceInSpace, ForceIsTheGradientOfTheEnergy) {
  for (int nodes : {4, 10}) {
    Body b(nodes);
    const Eigen::VectorXd u = b.deformed();
    b.move_to(u);
    const Eigen::VectorXd force = b.body.internal_force();
    Eigen::VectorXd measured(u.size());
    for (int c = 0; c < u.size(); ++c)
      measured[c] = finite_difference(
          [&](double t) {
            b.move_to(u + t * Eigen::VectorXd::Unit(u.size(), c));
            return b.energy();
          },
          0, 1e-3);
    EXPECT_GT(force.norm(), 0.1);
    EXPECT_LE((force - measured).norm(), 1e-11 * force.norm()) << nodes << " nodes";
  }
}

TEST(WorkpieceInSpace, TangentIsTheDerivativeOfTheForce) {
  for (int nodes : {4, 10}) {
    Body b(nodes);
    const Eigen::VectorXd u = b.deformed();
    b.move_to(u);
    NodeBlockMatrix<3> K = b.body.pattern();
    b.body.tangent(K, TangentKind::CONSISTENT);
    Eigen::MatrixXd measured(u.size(), u.size());
    for (int c = 0; c < u.size(); ++c)
      measured.col(c) = finite_difference(
          [&](double t) {
            b.move_to(u + t * Eigen::VectorXd::Unit(u.size(), c));
            return b.body.internal_force();
          },
          0, 1e-3);
    EXPECT_LE((dense(K) - measured).norm(), 1e-11 * measured.norm()) << nodes << " nodes";
  }
}

TEST(WorkpieceInSpace, ModuliOfAPointFromTheDerivativeOfTheStress) { // piola_tangent against the law's own
  Body b(4);
  b.move_to(b.deformed());
  const PointState<3> now = point_state(b.body.state(), 1);
  const Gradient<3> F = now.F;
  const auto kirchhoff = [&](const Gradient<3>& at) {
    std::vector<double> internal(7);
    PointTrial trial;
    PointUpdate<3> end;
    end.internal = internal.data();
    b.law->update({now, at, 0, 0, b.body.options()}, trial, end);
    return end.stress;
  };
  StressByF<3> by_F;
  for (int c = 0; c < 9; ++c)
    by_F.col(c) =
        finite_difference([&](double t) { return kirchhoff(F + t * Gradient<3>::Unit(c)); }, 0, 1e-3);
  const PiolaTangent<3> A = b.body.point_moduli(1, TangentKind::CONSISTENT);
  EXPECT_LE((piola_tangent<3>(by_F, now.stress, inverse(F)) - A).norm(), 1e-10 * A.norm());
}

TEST(WorkpieceInSpace, RotationsCauseNoForce) {
  for (int nodes : {4, 10}) {
    Body b(nodes);
    const Tensor<3> R = Eigen::AngleAxisd(0.8, Vector<3>(1, 2, -1).normalized()).toRotationMatrix();
    Eigen::VectorXd u(b.mesh().num_dofs());
    for (int a = 0; a < b.mesh().num_nodes; ++a)
      u.segment<3>(3 * a) = (R - Tensor<3>::Identity()) * b.mesh().node(a);
    b.move_to(u);
    EXPECT_LE(b.body.internal_force().norm(), 1e-14);
  }
}

TEST(WorkpieceInSpace, AcceptRevertAndCopies) {
  Body first(10), second(10);
  first.move_to(0.5 * first.deformed());
  first.body.accept();
  second.body.set_state(first.body.state_old());
  for (Body* b : {&first, &second}) b->move_to(b->deformed());
  EXPECT_EQ(first.body.state().stress, second.body.state().stress);
  EXPECT_EQ(first.body.state().internal, second.body.state().internal);
  EXPECT_EQ(first.body.internal_force(), second.body.internal_force());
  first.body.revert();
  EXPECT_EQ(first.body.state().F, second.body.state_old().F);
}

TEST(WorkpieceInSpace, EventsOfElements) {
  Body b(4);
  b.move_to(b.deformed());
  EXPECT_TRUE(element_events<3>(b.body, 0).empty());
  b.law->yield_at = 0.25;
  const auto events = element_events<3>(b.body, 0);
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(first_fraction(events), 0.25);
  EXPECT_EQ(earliest(events, 0).size(), 2u);
  const Vector<3> X(b.mesh().point[0], b.mesh().point[1], b.mesh().point[2]);
  const Vector<3> end = point_place(b.mesh(), 0, b.body.state());
  EXPECT_GT((end - X).norm(), 0.02);
  EXPECT_LE((events[0].x - (0.75 * X + 0.25 * end)).norm(), 1e-15);
  b.body.revert();
  accept_events(events, b.body);
  EXPECT_EQ(b.body.state().plastic, std::vector<char>(2, 1));
  b.body.update(b.deformed(), 1, 0);
  keep_plastic(0, b.body);
  EXPECT_EQ(b.body.state().plastic, std::vector<char>(2, 1));
}

TEST(WorkpieceInSpace, UserDefinedEvents) {
  Body b(4);
  PointEvents<3> events;
  EXPECT_EQ(PointVariables<3>(*b.law).names(),
            std::vector<std::string>(
                {"w", "seq", "sm", "sxx", "syy", "szz", "sxy", "syz", "szx", "s1", "s3", "x", "y", "z"}));
  b.move_to(b.deformed());
  const PointState<3> end = point_state(b.body.state(), 0);
  const std::map<std::string, double> at_end = {{"w", internal_field(b.body, "energy_density")[0]},
                                                {"syz", end.stress[4]},
                                                {"szx", end.stress[5]},
                                                {"s1", extreme_principals(Stress<3>(end.stress))[0]}};
  b.body.revert();
  for (const auto& [name, value] : at_end) events.add(b.body, name, name + "/v - 0.3", {{"v", value}});
  b.move_to(b.deformed());
  int at_first = 0;
  for (const auto& event : events.find(b.body)) {
    if (event.point != 0) continue;
    ++at_first;
    EXPECT_NEAR(event.fraction, 0.3, 1e-9) << event.name;
  }
  EXPECT_EQ(at_first, 4);
  events.accept(b.body);
  EXPECT_EQ(events.counts("w")[0], 1);
}

TEST(WorkpieceInSpace, PrincipalStresses) {
  const Tensor<3> R = Eigen::AngleAxisd(0.8, Vector<3>(1, 2, -1).normalized()).toRotationMatrix();
  const Tensor<3> t = R * Vector<3>(5, -2, 1).asDiagonal() * R.transpose();
  const Stress<3> stress = (Stress<3>() << t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(1, 2), t(2, 0)).finished();
  EXPECT_NEAR(extreme_principals(stress)[0], 5, 1e-14);
  EXPECT_NEAR(extreme_principals(stress)[1], -2, 1e-14);
  EXPECT_NEAR(equivalent<3>(deviator<3>(stress)), std::sqrt(0.5 * (49 + 9 + 16)), 1e-13);
  EXPECT_LE((matrix_of<3>(stress) - t).norm(), 1e-15);
}

TEST(WorkpieceInSpace, Fields) {
  Body b(10);
  b.move_to(b.deformed());
  const Eigen::VectorXd q = stress_eq_field(b.body), distance = yield_distance_field(b.body);
  const std::vector<double> P = piola_field(b.body), A = moduli_field(b.body, TangentKind::ELASTIC);
  EXPECT_EQ(q[3], stress_eq_field(b.body)[3]);
  EXPECT_EQ(distance, Eigen::VectorXd::Zero(8));
  EXPECT_EQ(P[9 * 3 + 5], carried_piola(b.body.state(), 3, false)[5]);
  EXPECT_EQ(A[81 * 3 + 9 * 5 + 2], b.body.point_moduli(3, TangentKind::ELASTIC)(5, 2));
  Eigen::VectorXd linear(8);
  for (int p = 0; p < 8; ++p) linear[p] = 2 + b.mesh().point[3 * p] - 3 * b.mesh().point[3 * p + 2];
  const Eigen::VectorXd nodal = nodal_average(b.mesh(), linear);
  int exact = 0;
  for (int a = 0; a < b.mesh().num_nodes; ++a)
    exact += std::abs(nodal[a] - (2 + b.mesh().node(a)[0] - 3 * b.mesh().node(a)[2])) < 1e-12;
  EXPECT_GE(exact, 1); // nodes inside, where the range of the points does not bind
  EXPECT_LE(nodal.maxCoeff(), linear.maxCoeff());
}

TEST(WorkpieceInSpace, FailuresAndErrors) {
  Body b(4);
  const UpdateResult result =
      b.body.update(-2 * Eigen::Map<const Eigen::VectorXd>(b.mesh().X.data(), 15), 1, 0);
  EXPECT_EQ(result.status, UpdateStatus::INVERTED_ELEMENT);
  EXPECT_NEAR(result.value, -1, 1e-12);
  Eigen::VectorXd u = b.deformed();
  u[3] = std::nan("");
  EXPECT_EQ(b.body.update(u, 1, 0).status, UpdateStatus::NOT_FINITE);
  expect_invalid([&] { internal_field(b.body, "ep"); },
                 "internal_field: law \"St Venant-Kirchhoff\" has no internal variable \"ep\", expected "
                 "one of second_piola, energy_density");
  expect_invalid([&] { internal_field(b.body, "second_piola", 6); }, "component = 6, expected 0..5");
  Discretization<3> ring = two_tetrahedra(4);
  ring.axisymmetric = true;
  expect_invalid([&] { Workpiece<3>(ring, b.law); }, "Workpiece: axisymmetric meshes are plane ones");
}
