// Rings: internal force and tangent with the hoop, patch tests, what must not strain, the axis.
#include "unit/material/j2/point_walk.hpp"
#include "unit/workpiece/patch.hpp"
#include "workpiece/element_events.hpp"
#include "workpiece/nodal_average.hpp"
#include "workpiece/point_fields.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// The patch of the given side as a ring of inner radius r.
Discretization<2> ring(int nodes, double r, double side = 1) {
  Discretization<2> plane = patch(nodes, side);
  for (int a = 0; a < plane.num_nodes; ++a) plane.X[2 * a] += r;
  return triangles(nodes, plane.X, plane.connectivity, true);
}

/// u_r = a r, u_z = b z: a constant state of strain.
Eigen::VectorXd stretched(const Discretization<2>& mesh, double a, double b) {
  return homogeneous(mesh, tensor(1 + a, 0, 0, 1 + b));
}

Eigen::MatrixXd tangent(const Workpiece<2>& body, TangentKind kind) {
  NodeBlockMatrix<2> matrix = body.pattern();
  body.tangent(matrix, kind);
  Eigen::MatrixXd K(matrix.size(), matrix.size());
  for (int c = 0; c < matrix.size(); ++c) K.col(c) = matrix.multiply(Eigen::VectorXd::Unit(matrix.size(), c));
  return K;
}

/// dF/du by finite differences, the numbers of substeps frozen as they are.
Eigen::MatrixXd measured_tangent(Workpiece<2> body, double step) {
  const Eigen::VectorXd u = body.state().displacement;
  Eigen::MatrixXd K(u.size(), u.size());
  for (int c = 0; c < u.size(); ++c) {
    const auto force = [&](double t) {
      body.update(u + t * Eigen::VectorXd::Unit(u.size(), c), body.state().dt, FREEZE_ITERATION);
      return body.internal_force();
    };
    K.col(c) = finite_difference(force, 0, step);
  }
  return K;
}

Eigen::MatrixXd symmetric_part(const Eigen::MatrixXd& K) { return 0.5 * (K + K.transpose()); }

/// A second step after an accepted one, hoop strains of about `size` too.
Workpiece<2> after_two_steps(int nodes, UpdateOptions options, double size) {
  Workpiece<2> body(ring(nodes, 0.4), j2_law<2>(example_material()), options);
  const Discretization<2>& mesh = body.discretization();
  body.update(bent(mesh, 1, size), 1, 0);
  body.accept();
  body.update(1.4 * bent(mesh, 1, size) + 0.2 * stretched(mesh, -size, -size), 0.8, 0);
  return body;
}

int plastic_points(const Workpiece<2>& body) {
  int sum = 0;
  for (char flag : body.state().plastic) sum += flag;
  return sum;
}

} // namespace

TEST(Axisymmetric, ConsistentTangentAgainstFiniteDifferences) {
  for (StressUpdate update : {StressUpdate::SUBSTEPPED, StressUpdate::SINGLE, StressUpdate::FORWARD_EULER})
    for (StrainFrame frame : {StrainFrame::MIDPOINT, StrainFrame::END})
      for (int nodes : {3, 6})
        for (double size : {1e-4, 0.02}) {
          UpdateOptions options;
          options.update = update;
          options.strain_frame = frame;
          const Workpiece<2> body = after_two_steps(nodes, options, size);
          if (size == 1e-4)
            ASSERT_EQ(plastic_points(body), 0);
          else
            ASSERT_GT(plastic_points(body), body.discretization().num_points() / 2);
          const Eigen::MatrixXd K = tangent(body, TangentKind::CONSISTENT),
                                measured = symmetric_part(measured_tangent(body, 1e-6));
          EXPECT_LE((K - measured).norm() / K.norm(), 2e-8) << "strain " << size << ", nodes " << nodes;
        }
}

TEST(Axisymmetric, RateTangentIsTheLimitOfTheConsistentOne) { // CONSISTENT is tested by differences
  for (int nodes : {3, 6}) {
    UpdateOptions options;
    options.update = StressUpdate::SINGLE;
    Workpiece<2> body = after_two_steps(nodes, options, 0.02);
    const Discretization<2>& mesh = body.discretization();
    body.accept();
    const Eigen::MatrixXd rate = tangent(body, TangentKind::RATE);
    EXPECT_LE((rate - rate.transpose()).norm(), 1e-14 * rate.norm());
    const Eigen::VectorXd start = body.state().displacement,
                          on = 1.4 * bent(mesh, 1, 1) + 0.2 * stretched(mesh, -1, -1);
    double before = 0;
    for (double size : {4e-6, 2e-6, 1e-6}) {
      body.revert();
      const std::vector<char> plastic = body.state().plastic;
      body.update(start + size * on, 1, 0);
      ASSERT_EQ(body.state().plastic, plastic); // the same points load
      const double error = (tangent(body, TangentKind::CONSISTENT) - rate).norm() / rate.norm();
      if (before > 0) {
        EXPECT_NEAR(before / error, 2, 0.1) << "step " << size;
      }
      before = error;
    }
    EXPECT_LE(before, 1e-3);
  }
}

TEST(Axisymmetric, ConstantStrainIsExact) { // with the axis (r = 0) and without; small, plastic, large
  for (int nodes : {3, 6})
    for (double r : {0., 2.})
      for (double size : {1e-8, 5e-3, 0.3}) {
        Workpiece<2> body(ring(nodes, r), j2_law<2>(example_material()));
        const Discretization<2>& mesh = body.discretization();
        const double a = 0.7 * size, b = -size;
        ASSERT_EQ(body.update(stretched(mesh, a, b), 1, 0).status, UpdateStatus::OK);
        const Stress<2> stress = stress_at(body.state(), 0);
        const double tolerance = size > 1e-6 ? 1e-11 : 1e-7;
        if (size < 1e-6) { // small strain elasticity
          Stress<2> expected = deviatoric_stress<2>(example_material().elastic, {a, b, a, 0});
          expected.head<3>().array() += example_material().elastic.K * (2 * a + b);
          expect_close(stress, expected, expected.norm(), 1e-7, "E:eps");
        }
        for (int p = 0; p < mesh.num_points(); ++p) {
          EXPECT_NEAR(gradient_at(body.state(), p)[ZZ], 1 + a, 1e-14);
          expect_close(stress_at(body.state(), p), stress, stress.norm(), tolerance, "stress");
        }
        EXPECT_NEAR(stress[0], stress[2], tolerance * stress.norm()); // radial = hoop
        // no force inside or on the axis; the outer side carries P_rr, the ends P_zz
        double side = 0, end = 0;
        const Gradient<2> P = carried_piola(body.state(), 0, false);
        const Eigen::VectorXd force = body.internal_force();
        for (int n = 0; n < mesh.num_nodes; ++n) {
          const Vector<2> X = mesh.node(n);
          const bool inner = X[0]<r + 1e-9, outer = X[0]> r + 1 - 1e-9, top = X[1] > 1 - 1e-9;
          if (outer) side += force[2 * n];
          if (top) end += force[2 * n + 1];
          if (!outer && (!inner || r == 0)) {
            EXPECT_NEAR(force[2 * n], 0, tolerance * force.norm()) << "node " << n;
          }
          if (!top && X[1] > 1e-9) {
            EXPECT_NEAR(force[2 * n + 1], 0, tolerance * force.norm()) << "node " << n;
          }
        }
        EXPECT_NEAR(side / (2 * M_PI * (r + 1) * P[0]), 1, tolerance);
        EXPECT_NEAR(end / (M_PI * ((r + 1) * (r + 1) - r * r) * P[3]), 1, tolerance);
      }
}

TEST(Axisymmetric, TranslationAlongTheAxisStrainsNothing) {
  for (int nodes : {3, 6}) {
    Workpiece<2> body = after_two_steps(nodes, {}, 0.02);
    body.accept();
    const Discretization<2>& mesh = body.discretization();
    const Eigen::VectorXd force = body.internal_force();
    Eigen::VectorXd shift = Eigen::VectorXd::Zero(mesh.num_dofs());
    for (int a = 0; a < mesh.num_nodes; ++a) shift[2 * a + 1] = 1;
    EXPECT_LE(std::abs(force.dot(shift)), 1e-12 * force.cwiseAbs().sum()); // equilibrium along the axis
    EXPECT_LE((tangent(body, TangentKind::RATE) * shift).norm(),
              1e-11 * tangent(body, TangentKind::RATE).norm());
    const Stress<2> before = stress_at(body.state(), 1);
    ASSERT_EQ(body.update(body.state().displacement + 0.7 * shift, 1, 0).status, UpdateStatus::OK);
    expect_close(stress_at(body.state(), 1), before, before.norm(), 1e-11, "stress");
    EXPECT_LE((body.internal_force() - force).norm(), 1e-11 * force.norm());
  }
}

TEST(Axisymmetric, ForceIsTheWorkOfTheStress) { // f . du = sum V0 P dF over the whole ring
  for (int nodes : {3, 6}) {
    const Workpiece<2> body = after_two_steps(nodes, {}, 0.02);
    const Discretization<2>& mesh = body.discretization();
    const Eigen::VectorXd du = bent(mesh, 1, 1);
    Workpiece<2> moved(mesh, j2_law<2>(example_material()));
    moved.update(1e-3 * du, 1, 0); // only for its F - I = dF
    double work = 0;
    for (int p = 0; p < mesh.num_points(); ++p) {
      work +=
          mesh.weight[p] *
          carried_piola(body.state(), p, false).dot(1e3 * (gradient_at(moved.state(), p) - undeformed<2>()));
    }
    EXPECT_NEAR(body.internal_force().dot(du) / work, 1, 1e-12);
  }
}

TEST(Axisymmetric, SameInMetersAndInMillimeters) {
  Workpiece<2> meters(ring(6, 0.4), j2_law<2>(example_material())),
      millimeters(ring(6, 400, 1e3), j2_law<2>(J2Parameters::from_shear(2.7e4, 0.32, 193, 962)));
  for (Workpiece<2>* body : {&meters, &millimeters}) {
    const double side = body == &meters ? 1 : 1e3;
    body->update(bent(body->discretization(), side, 0.02), 1, 0);
  }
  const Eigen::VectorXd force = meters.internal_force(); // N: of the whole ring
  EXPECT_LE((millimeters.internal_force() - force).norm(), 1e-12 * force.norm());
  EXPECT_LE(
      (1e3 * tangent(millimeters, TangentKind::CONSISTENT) - tangent(meters, TangentKind::CONSISTENT)).norm(),
      1e-12 * tangent(meters, TangentKind::CONSISTENT).norm());
}

TEST(Axisymmetric, AWideRingIsABlockInPlaneStrain) { // force per circumference, error O(1/R); P1: same points
  double before = 0;
  for (double R : {1e3, 2e3}) {
    Workpiece<2> plane(patch(3, 1), j2_law<2>(example_material())),
        wide(ring(3, R), j2_law<2>(example_material()));
    for (Workpiece<2>* body : {&plane, &wide}) body->update(bent(plane.discretization(), 1, 0.02), 1, 0);
    const Eigen::VectorXd force = plane.internal_force();
    const double error = (wide.internal_force() / (2 * M_PI * R) - force).norm() / force.norm();
    EXPECT_LE(error, 5 / R);
    if (before > 0) {
      EXPECT_NEAR(before / error, 2, 0.1);
    }
    before = error;
  }
}

TEST(Axisymmetric, RingsTurnedInsideOut) { // det F counts the hoop
  Workpiece<2> body(ring(3, 2), j2_law<2>(example_material()));
  const Discretization<2>& mesh = body.discretization();
  Eigen::VectorXd u = Eigen::VectorXd::Zero(mesh.num_dofs());
  for (int a = 0; a < mesh.num_nodes; ++a) u[2 * a] = -4; // across the axis as it is
  UpdateResult result = body.update(u, 1, 0);
  EXPECT_EQ(result.status, UpdateStatus::INVERTED_ELEMENT);
  EXPECT_LT(result.value, 0);
  for (int a = 0; a < mesh.num_nodes; ++a) u[2 * a] = -2 * mesh.node(a)[0]; // and mirrored
  result = body.update(u, 1, 0);
  EXPECT_EQ(result.status, UpdateStatus::INVERTED_ELEMENT);
  EXPECT_NEAR(result.value, -1, 1e-12);
}

TEST(Axisymmetric, TheAxisMustBeHeld) {
  Workpiece<2> body(ring(6, 0), j2_law<2>(example_material()));
  Eigen::VectorXd u = Eigen::VectorXd::Zero(body.discretization().num_dofs());
  u[2 * 3] = 1e-14; // rounding
  u[2 * 3 + 1] = 1e-3;
  EXPECT_EQ(body.update(u, 1, 0).status, UpdateStatus::OK);
  u[2 * 3] = 1e-3;
  expect_invalid(
      [&] { body.update(u, 1, 0); },
      "Workpiece::update: radial displacement of node 3 on the axis = 0.001, expected 0: constrain it");
}

TEST(Axisymmetric, AStepCutAtTheYieldEventEndsOnTheSurface) {
  Workpiece<2> body(ring(6, 0.4), j2_law<2>(example_material()));
  const Eigen::VectorXd u = stretched(body.discretization(), 0.02, 0.004);
  body.update(u, 1, 0);
  const auto events = element_events<2>(body, 0);
  ASSERT_EQ(static_cast<int>(events.size()), body.discretization().num_points());
  body.revert();
  body.update(events[0].fraction * u, 1, 0);
  EXPECT_NEAR(yield_distance(body, events[0].point), 0, 1e-12);
  const int p = events[0].point;
  const double* X = &body.discretization().point[2 * p]; // where it was found: an inner point of P2
  EXPECT_NEAR(events[0].x[0], X[0] * (1 + 0.02 * events[0].fraction), 1e-14);
  EXPECT_NEAR(events[0].x[1], X[1] * (1 + 0.004 * events[0].fraction), 1e-14);
}

TEST(Axisymmetric, NodalAverageOfALinearField) {
  const Discretization<2> mesh = ring(6, 0.4);
  Eigen::VectorXd values(mesh.num_points());
  const auto field = [](const double* x) { return 2 + 3 * x[0] - 5 * x[1]; };
  for (int p = 0; p < mesh.num_points(); ++p) values[p] = field(&mesh.point[2 * p]);
  const Eigen::VectorXd nodal = nodal_average(mesh, values);
  int exact = 0;
  for (int a = 0; a < mesh.num_nodes; ++a) exact += std::abs(nodal[a] - field(mesh.node(a).data())) < 1e-12;
  EXPECT_GE(exact, 4); // nodes inside, where the range of the points does not bind
}
