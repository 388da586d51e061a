// Internal force and tangent: patch test, finite differences, kinds of tangent, units.
#include "unit/material/j2/point_walk.hpp"
#include "unit/workpiece/patch.hpp"
#include "workpiece/assembly.hpp"
#include "workpiece/point_fields.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

Workpiece<2> workpiece(int nodes, UpdateOptions options = {}) {
  return {patch(nodes, 1), j2_law<2>(example_material()), options};
}

Eigen::MatrixXd dense(const NodeBlockMatrix<2>& matrix) {
  Eigen::MatrixXd K(matrix.size(), matrix.size());
  for (int c = 0; c < matrix.size(); ++c) K.col(c) = matrix.multiply(Eigen::VectorXd::Unit(matrix.size(), c));
  return K;
}

Eigen::MatrixXd tangent(const Workpiece<2>& body, TangentKind kind, double elastic_blend = 0) {
  NodeBlockMatrix<2> matrix = body.pattern();
  std::fill(matrix.value.begin(), matrix.value.end(), 1e30); // must be replaced
  body.tangent(matrix, kind, elastic_blend);
  return dense(matrix);
}

/// With the antisymmetric part.
Eigen::MatrixXd full_tangent(const Workpiece<2>& body) {
  NodeBlockMatrix<2> matrix = body.pattern();
  body.tangent(matrix, TangentKind::CONSISTENT);
  body.add_antisymmetric_tangent(matrix, TangentKind::CONSISTENT);
  return dense(matrix);
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

/// After one accepted step: a second one, with strains of about `size` and every point elastic or most
/// plastic.
Workpiece<2> after_two_steps(int nodes, UpdateOptions options, double size) {
  Workpiece<2> body = workpiece(nodes, options);
  const Discretization<2>& mesh = body.discretization();
  body.update(bent(mesh, 1, size), 1, 0);
  body.accept();
  body.update(1.4 * bent(mesh, 1, size) + 0.2 * homogeneous(mesh, tensor(1, -size, 0, 1 - size)), 0.8, 0);
  return body;
}

int plastic_points(const Workpiece<2>& body) {
  int sum = 0;
  for (char flag : body.state().plastic) sum += flag;
  return sum;
}

} // namespace

TEST(Assembly, PatchTest) {
  for (int nodes : {3, 6})
    for (double size : {1e-8, 5e-3, 0.3}) { // small strain, plastic, large
      Workpiece<2> body = workpiece(nodes);
      const Discretization<2>& mesh = body.discretization();
      const Tensor<2> F = Tensor<2>::Identity() + size * tensor(1, 0.4, -0.3, 0.6);
      body.update(homogeneous(mesh, F), 1, 0);
      const Stress<2> stress = stress_at(body.state(), 0);
      for (int p = 0; p < mesh.num_points(); ++p)
        expect_close(stress_at(body.state(), p), stress, stress.norm(), size > 1e-6 ? 1e-12 : 1e-7, "stress");
      if (size < 1e-6) { // small strain elasticity
        Stress<2> expected =
            deviatoric_stress<2>(example_material().elastic, size * Stress<2>(1, 0.6, 0, 0.05));
        expected.head<3>().array() += example_material().elastic.K * size * 1.6;
        expect_close(stress, expected, expected.norm(), 1e-7, "E:eps");
      }
      // no force inside, traction P N on the side x = 1
      const Eigen::VectorXd force = body.internal_force();
      Vector<2> side = Vector<2>::Zero();
      for (int a = 0; a < mesh.num_nodes; ++a) {
        const Vector<2> X = mesh.node(a);
        const bool inside = X.minCoeff() > 1e-9 && X.maxCoeff() < 1 - 1e-9;
        if (inside) {
          EXPECT_LE(force.segment<2>(2 * a).norm(), 1e-7 * force.norm()) << "node " << a;
        }
        if (X[0] > 1 - 1e-9 && X[1] > 1e-9 && X[1] < 1 - 1e-9) side += force.segment<2>(2 * a);
      }
      const Gradient<2> P = carried_piola(body.state(), 0, false);
      // corner nodes also carry the other sides: P1 gives the middle node 1/2, P2 the three inner ones 1 -
      // 1/6
      const double share = nodes == 3 ? 0.5 : 1 - 1. / 6;
      expect_close(side, share * Vector<2>(P[0], P[2]), stress.norm(), 1e-7, "P N");
      EXPECT_LE((force(Eigen::seq(0, Eigen::last, 2)).sum()), 1e-7 * force.norm()); // equilibrium
    }
}

TEST(Assembly, ElasticTangentAgainstFiniteDifferences) {
  for (int nodes : {3, 6})
    for (double size : {1e-4, 1e-3}) {
      const Workpiece<2> body = after_two_steps(nodes, {}, size);
      ASSERT_EQ(plastic_points(body), 0);
      const Eigen::MatrixXd K = tangent(body, TangentKind::CONSISTENT),
                            measured = measured_tangent(body, 1e-5);
      EXPECT_LE((K - K.transpose()).norm(), 1e-15 * K.norm());
      EXPECT_LE((K - symmetric_part(measured)).norm() / K.norm(), 1e-9) << "strain " << size;
      EXPECT_LE((K - measured).norm() / K.norm(), size) << "strain " << size; // the nonsymmetry left out
      EXPECT_LE((full_tangent(body) - measured).norm() / K.norm(), 1e-9) << "strain " << size;
    }
}

TEST(Assembly, PlasticTangentAgainstFiniteDifferences) {
  for (StressUpdate update : {StressUpdate::SUBSTEPPED, StressUpdate::SINGLE, StressUpdate::FORWARD_EULER})
    for (StrainFrame frame : {StrainFrame::MIDPOINT, StrainFrame::END})
      for (int nodes : {3, 6}) {
        UpdateOptions options;
        options.update = update;
        options.strain_frame = frame;
        const Workpiece<2> body = after_two_steps(nodes, options, 0.02);
        ASSERT_GT(plastic_points(body), body.discretization().num_points() / 2);
        const Eigen::MatrixXd K = tangent(body, TangentKind::CONSISTENT),
                              measured = measured_tangent(body, 1e-6);
        EXPECT_LE((K - symmetric_part(measured)).norm() / K.norm(), 1e-8);
        EXPECT_GE((K - measured).norm() / K.norm(), 1e-6) << "the nonsymmetry left out";
        EXPECT_LE((full_tangent(body) - measured).norm() / K.norm(), 1e-8);
      }
}

TEST(Assembly, ElasticKindIsTheTangentOfASmallStepFromRest) {
  for (int nodes : {3, 6}) {
    Workpiece<2> body = workpiece(nodes);
    const Discretization<2>& mesh = body.discretization();
    WorkpieceState<2> start = body.state();
    for (int p = 0; p < mesh.num_points(); ++p) start.stress[4 * p] = start.stress[4 * p + 3] = 5e7;
    body.set_state(start);
    body.update(1e-9 * bent(mesh, 1, 1), 1, 0);
    const Eigen::MatrixXd K = tangent(body, TangentKind::ELASTIC);
    EXPECT_LE((K - measured_tangent(body, 1e-5)).norm() / K.norm(), 1e-8);
  }
}

TEST(Assembly, ElasticKindIgnoresFlow) {
  const Workpiece<2> body = after_two_steps(6, {}, 0.02);
  for (int p : {0, 11, 23}) {
    const PiolaTangent<2> A = body.point_moduli(p, TangentKind::ELASTIC);
    const Gradient<2> F = gradient_at(body.state(), p);
    const PiolaTangent<2> expected =
        rate_tangent<2>(example_material(), stress_at(body.state(), p), 0, F, false);
    EXPECT_LE((A - expected).norm(), 1e-14 * expected.norm());
  }
}

TEST(Assembly, RateKindLoadsWhereThePointFlowed) {
  const Workpiece<2> body = after_two_steps(6, {}, 0.0012);
  const int points = body.discretization().num_points();
  ASSERT_GT(plastic_points(body), 0);
  ASSERT_LT(plastic_points(body), points);
  for (int p = 0; p < points; ++p) {
    const PiolaTangent<2> A = body.point_moduli(p, TangentKind::RATE);
    const Gradient<2> F = gradient_at(body.state(), p);
    const PiolaTangent<2> expected =
        rate_tangent<2>(example_material(), stress_at(body.state(), p), plastic_strain_eq_at(body.state(), p),
                        F, body.state().plastic[p]);
    EXPECT_LE((A - expected).norm(), 1e-14 * expected.norm()) << "point " << p;
  }
}

TEST(Assembly, ConsistentIsRateWhereThereIsNoIncrement) {
  Workpiece<2> body = after_two_steps(3, {}, 0.02);
  const Eigen::MatrixXd before = tangent(body, TangentKind::CONSISTENT);
  EXPECT_NE(before, tangent(body, TangentKind::RATE));
  body.accept();
  EXPECT_EQ(tangent(body, TangentKind::CONSISTENT), tangent(body, TangentKind::RATE));
  body.update(1.1 * body.state().displacement, 1, 0);
  EXPECT_NE(tangent(body, TangentKind::CONSISTENT), tangent(body, TangentKind::RATE));
  body.revert();
  EXPECT_EQ(tangent(body, TangentKind::CONSISTENT), tangent(body, TangentKind::RATE));
}

TEST(Assembly, BlendMixesElasticModuliIntoPlasticPoints) {
  const Workpiece<2> body = after_two_steps(6, {}, 0.0012);
  ASSERT_EQ(plastic_points(body), 9); // of 24
  for (TangentKind kind : {TangentKind::CONSISTENT, TangentKind::RATE})
    for (int p = 0; p < body.discretization().num_points(); ++p) {
      const PiolaTangent<2> pure = body.point_moduli(p, kind), blended = body.point_moduli(p, kind, 0.2);
      const PiolaTangent<2> elastic = body.point_moduli(p, TangentKind::ELASTIC);
      const PiolaTangent<2> expected =
          body.state().plastic[p] ? PiolaTangent<2>(0.8 * pure + 0.2 * elastic) : pure;
      EXPECT_LE((blended - expected).norm(), 1e-14 * pure.norm()) << "point " << p;
    }
}

// From the second switch on .03 of elastic moduli for each, .3 at most; a new step begins without.
TEST(Assembly, PointsThatGoToAndFroGetElasticModuli) {
  Workpiece<2> body = workpiece(6, {});
  const Eigen::VectorXd plastic = bent(body.discretization(), 1, 0.002), elastic = 0 * plastic;
  Workpiece<2> once = body;
  once.update(plastic, 1, 0);
  ASSERT_GT(plastic_points(once), 0);
  for (int iteration = 0; iteration <= 14; ++iteration) {
    body.update(iteration % 2 ? elastic : plastic, 1, iteration);
    if (iteration % 2) continue;
    const double part = iteration < 2 ? 0 : std::min(0.03 * iteration, 0.3);
    for (int p = 0; p < body.discretization().num_points(); ++p) {
      const PiolaTangent<2> pure = once.point_moduli(p, TangentKind::CONSISTENT);
      const PiolaTangent<2> stiff = once.point_moduli(p, TangentKind::ELASTIC);
      const PiolaTangent<2> expected =
          once.state().plastic[p] ? PiolaTangent<2>(pure + part * (stiff - pure)) : pure;
      EXPECT_LE((body.point_moduli(p, TangentKind::DAMPED) - expected).norm(), 1e-14 * pure.norm());
      EXPECT_EQ(body.point_moduli(p, TangentKind::CONSISTENT), pure);
    }
  }
  EXPECT_EQ(tangent(body, TangentKind::RATE), tangent(once, TangentKind::RATE));
  body.update(plastic, 1, 0);
  EXPECT_EQ(tangent(body, TangentKind::DAMPED), tangent(once, TangentKind::CONSISTENT));
}

TEST(Assembly, PointModuliAndPiolaGiveTheSameForms) {
  const Workpiece<2> body = after_two_steps(6, {}, 0.01);
  const Discretization<2>& mesh = body.discretization();
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(mesh.num_dofs(), mesh.num_dofs());
  Eigen::VectorXd force = Eigen::VectorXd::Zero(mesh.num_dofs());
  for (int p = 0; p < mesh.num_points(); ++p) {
    const PiolaTangent<2> A = body.point_moduli(p, TangentKind::CONSISTENT);
    const Gradient<2> P = carried_piola(body.state(), p, false);
    Eigen::MatrixXd B = Eigen::MatrixXd::Zero(5, mesh.num_dofs()); // [du/dx, du/dy, dv/dx, dv/dy, 0]
    for (int a = 0; a < mesh.nodes_per_element; ++a)
      for (int i = 0; i < 2; ++i)
        for (int J = 0; J < 2; ++J)
          B(2 * i + J, 2 * mesh.element(p / 3)[a] + i) = mesh.gradients(p)[2 * a + J];
    K += mesh.weight[p] * B.transpose() * A * B;
    force += mesh.weight[p] * B.transpose() * P;
  }
  EXPECT_LE((K - tangent(body, TangentKind::CONSISTENT)).norm(), 1e-14 * K.norm());
  EXPECT_LE((force - body.internal_force()).norm(), 1e-14 * force.norm());
}

TEST(Assembly, SameInMetersAndInMillimeters) {
  for (StressUpdate update : {StressUpdate::SUBSTEPPED, StressUpdate::SINGLE, StressUpdate::FORWARD_EULER}) {
    UpdateOptions options;
    options.update = update;
    const Workpiece<2> meters = after_two_steps(6, options, 0.02);
    Workpiece<2> millimeters(patch(6, 1e3), j2_law<2>(J2Parameters::from_shear(2.7e4, 0.32, 193, 962)),
                             options);
    const Discretization<2>& mesh = millimeters.discretization();
    millimeters.update(bent(mesh, 1e3, 0.02), 1e3, 0);
    millimeters.accept();
    millimeters.update(1.4 * bent(mesh, 1e3, 0.02) + 0.2 * homogeneous(mesh, tensor(1, -0.02, 0, 0.98)),
                       0.8e3, 0);
    const Eigen::VectorXd force = meters.internal_force(); // N/m; N/mm are 1e3 of them
    EXPECT_LE((1e3 * millimeters.internal_force() - force).norm(), 1e-12 * force.norm());
    const Eigen::MatrixXd K = tangent(meters, TangentKind::CONSISTENT);
    EXPECT_LE((1e6 * tangent(millimeters, TangentKind::CONSISTENT) - K).norm(), 1e-11 * K.norm());
    EXPECT_EQ(millimeters.state().plastic, meters.state().plastic);
    for (int p = 0; p < mesh.num_points(); ++p) {
      EXPECT_NEAR(plastic_strain_eq_at(millimeters.state(), p), plastic_strain_eq_at(meters.state(), p),
                  1e-14);
      EXPECT_NEAR(1e6 * stress_eq_field(millimeters)[p] / stress_eq_field(meters)[p], 1, 1e-12);
    }
  }
}

TEST(Assembly, VonMisesStress) {
  Workpiece<2> body = workpiece(3);
  WorkpieceState<2> state = body.state();
  state.stress[4 * 5] = 7; // uniaxial
  state.stress[4 * 6 + 3] = 2;
  body.set_state(state);
  EXPECT_NEAR(stress_eq_field(body)[5], 7, 1e-14);
  EXPECT_NEAR(stress_eq_field(body)[6], 2 * std::sqrt(3.0), 1e-14);
}

TEST(Assembly, Errors) {
  const Workpiece<2> body = workpiece(3);
  NodeBlockMatrix<2> other = workpiece(6).pattern(), matrix = body.pattern();
  expect_invalid([&] { body.tangent(other, TangentKind::RATE); },
                 "Workpiece::tangent: the matrix has another pattern");
  expect_invalid([&] { body.tangent(matrix, TangentKind::RATE, 1.5); },
                 "Workpiece::tangent: elastic_blend = 1.5, expected 0 <= elastic_blend <= 1");
  expect_invalid([&] { body.add_antisymmetric_tangent(matrix, TangentKind::RATE); },
                 "Workpiece::add_antisymmetric_tangent: the matrix is not one that tangent() has filled");
  expect_invalid([&] { body.point_moduli(8, TangentKind::RATE); },
                 "Workpiece::point_moduli: point = 8, expected 0 <= point < num_points");
  expect_invalid([&] { body.point_moduli(0, TangentKind::RATE, -1); },
                 "Workpiece::point_moduli: elastic_blend = -1");
  const int around = 65535; // triangles in a fan, their tip has one neighbor more
  std::vector<double> X{0, 0, 1, 0};
  std::vector<int> triangle;
  for (int i = 1; i <= around; ++i) {
    X.insert(X.end(), {std::cos(6. * i / around), std::sin(6. * i / around)});
    triangle.insert(triangle.end(), {0, i, i + 1});
  }
  expect_invalid([&] { TangentAssembly<2>(triangles(3, X, triangle)); },
                 "TangentAssembly: nodes in elements with node 0 = 65537, expected at most 65535");
}
