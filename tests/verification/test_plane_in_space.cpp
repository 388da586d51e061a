// Bodies in space in states of the plane: simple shear in any plane (S1), rigid rotations about any axis (S2).
#include "material/make_law.hpp"
#include "support/tetrahedra.hpp"
#include "unit/material/in_space.hpp"
#include "unit/material/j2/law_point.hpp"
#include "unit/workpiece/patch.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

std::vector<LawInput> laws() {
  std::vector<LawInput> list;
  for (const char* rate : {"jaumann", "greennaghdi", "logarithmic"}) {
    const auto add = [&](LawNumbers numbers, const char* hardening, const char* backstress) {
      LawInput input{with_example_elasticity(std::move(numbers))};
      input.hardening = hardening;
      input.backstress = backstress;
      input.rate = rate;
      list.push_back(input);
    };
    add({{"sigY", 1e13}, {"H", 0}}, "linear", "none");
    add({{"sigY", 1.93e8}}, "perfect", "none");
    add({{"sigY", 1.93e8}, {"H", 9.62e8}}, "linear", "none");
    add({}, "193e6*(1 + ep/0.002)^0.2", "none");
    add({{"sigY", 1.93e8}, {"H", 9.62e8}, {"C", 3e9}}, "linear", "prager");
    add({{"C", 8e9}, {"gamma", 60}}, "193e6*(1 + ep/0.002)^0.2", "armstrongfrederick");
    list.push_back({with_example_elasticity({})});
    list.back().rate = rate;
    list.back().plastic_strain = {0, 0.004, 0.2};
    list.back().yield_stress = {193e6, 240e6, 600e6};
  }
  return list;
}

/// On corners of the unit cube, where gradients of linear functions have no rounding.
Discretization<3> two_in_the_unit_cube(int nodes_per_element) {
  const Mesh<3> linear =
      linear_tetrahedra({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1}, {0, 1, 2, 3, 1, 2, 3, 4});
  return tetrahedra(nodes_per_element == 4 ? linear : quadratic_tetrahedra(linear));
}

} // namespace

// The mean stress has the rounding of F times bulk modulus over yield stress (300), so the shear is I + gamma a b' of the turned
// directions: Q F Q' has a determinant off by more.
TEST(PlaneInSpace, SimpleShearInAnyPlane) {
  const int steps = 25;
  const double gamma = 1.5;
  const Tensor<3> planes[] = {Tensor<3>::Identity(), turn_about({1, 0, 0}, M_PI / 2),
                              turn_about({1, 2, -1}, 1.1)};
  double worst = 0, worst_deviator = 0;
  for (const LawInput& law : laws())
    for (const int nodes : {4, 10}) {
      Workpiece<2> flat(patch(3, 1), make_law<2>(law, "test"));
      std::vector<Workpiece<3>> bodies(3,
                                       Workpiece<3>(two_in_the_unit_cube(nodes), make_law<3>(law, "test")));
      for (int k = 1; k <= steps; ++k) {
        const Gradient<2> F = gradient(tensor(1, gamma * k / steps, 0, 1));
        ASSERT_EQ(flat.update(homogeneous(flat.discretization(), in_plane(F)), 1, 0).status,
                  UpdateStatus::OK);
        flat.accept();
        for (std::size_t i = 0; i < bodies.size(); ++i) {
          const Tensor<3> F_space =
              Tensor<3>::Identity() + gamma * k / steps * planes[i].col(0) * planes[i].col(1).transpose();
          const Eigen::VectorXd u = homogeneous(bodies[i].discretization(), F_space);
          ASSERT_EQ(bodies[i].update(u, 1, 0).status, UpdateStatus::OK);
          bodies[i].accept();
        }
      }
      const Stress<2> expected = stress_at(flat.state(), 0);
      for (std::size_t i = 0; i < bodies.size(); ++i)
        for (int p = 0; p < bodies[i].discretization().num_points(); ++p) {
          Stress<3> off = (point_state(bodies[i].state(), p).stress - in_space(expected, planes[i]));
          off /= expected.norm();
          worst = std::max(worst, off.norm());
          off.head<3>().array() -= off.head<3>().mean();
          worst_deviator = std::max(worst_deviator, off.norm());
        }
    }
  EXPECT_LE(worst, 1e-12);
  EXPECT_LE(worst_deviator, 1e-13);
  std::cout << "stress differs from the plane's by " << worst << " of it, its deviator by " << worst_deviator
            << "\n";
}

TEST(PlaneInSpace, ARigidRotationAboutAnyAxisTurnsTheStress) {
  double worst = 0;
  for (const LawInput& law : laws())
    for (int nodes : {4, 10})
      for (const Vector<3>& axis : {Vector<3>(0, 1, 0), Vector<3>(1, 2, -1), Vector<3>(-0.3, 0.1, 1)})
        for (const int steps : {1, 4}) {
          Workpiece<3> body(two_tetrahedra(nodes), make_law<3>(law, "test"));
          const Discretization<3>& mesh = body.discretization();
          Eigen::VectorXd start(mesh.num_dofs());
          for (int a = 0; a < mesh.num_nodes; ++a) {
            const Vector<3> X = mesh.node(a);
            start.segment<3>(3 * a) = 0.03 * Vector<3>(X[0] - X[1] * X[2], 0.4 * X[2] - X[1], X[0] * X[0]);
          }
          for (const double part : {0.5, 1.}) {
            ASSERT_EQ(body.update(part * start, 1, 0).status, UpdateStatus::OK);
            body.accept();
          }
          const WorkpieceState<3> before = body.state();
          const double angle = 2.8;
          for (int k = 1; k <= steps; ++k) {
            const Tensor<3> R = turn_about(axis, angle * k / steps);
            Eigen::VectorXd u(mesh.num_dofs());
            for (int a = 0; a < mesh.num_nodes; ++a)
              u.segment<3>(3 * a) = R * (mesh.node(a) + start.segment<3>(3 * a)) - mesh.node(a);
            ASSERT_EQ(body.update(u, 1, 0).status, UpdateStatus::OK);
            body.accept();
          }
          for (int p = 0; p < mesh.num_points(); ++p) {
            const Stress<3> old = point_state(before, p).stress, now = point_state(body.state(), p).stress;
            worst = std::max(worst, (now - rotated(old, turn_about(axis, angle))).norm() / old.norm());
          }
        }
  EXPECT_LE(worst, 1e-10);
  std::cout << "stress differs from the turned one by " << worst << " of it\n";
}
