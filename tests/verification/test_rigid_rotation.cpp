// S2: a stressed body turned rigidly. The stress turns with it, exactly, whatever the number of steps.
#include "unit/workpiece/patch.hpp"
#include <cmath>
#include <gtest/gtest.h>

using namespace burnish;
using namespace burnish::test;

namespace {

Tensor<2> rotation_by(double angle) {
  Tensor<2> R;
  R << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return R;
}

Tensor<2> in_plane(const Stress<2>& stress) {
  Tensor<2> t;
  t << stress[0], stress[3], stress[3], stress[1];
  return t;
}

/// Stretched and bent until some or all points flow (or none), then every node turned about the origin.
struct Turned {
  Workpiece<2> body;
  Eigen::VectorXd start; // displacement

  Turned(int nodes_per_element, UpdateOptions options, double strain)
      : body(patch(nodes_per_element, 0.03),
             j2_law<2>(J2Parameters::from_shear(2.7e10, 0.32, 1.93e8, 9.62e8)), options) {
    start = bent(body.discretization(), 0.03, strain);
    for (double part : {0.5, 1.0}) {
      body.update(part * start, 1, 0);
      body.accept();
    }
  }
  void turn_to(double angle) {
    const Discretization<2>& mesh = body.discretization();
    Eigen::VectorXd u(mesh.num_dofs());
    for (int a = 0; a < mesh.num_nodes; ++a)
      u.segment<2>(2 * a) = rotation_by(angle) * (mesh.node(a) + start.segment<2>(2 * a)) - mesh.node(a);
    ASSERT_EQ(body.update(u, 1, 0).status, UpdateStatus::OK);
    body.accept();
  }
};

/// Largest difference from R tau R', relative to the largest stress.
double error(const WorkpieceState<2>& before, const WorkpieceState<2>& after, double angle) {
  const Tensor<2> R = rotation_by(angle);
  double largest = 0, difference = 0;
  for (std::size_t p = 0; p < before.plastic.size(); ++p) {
    const Stress<2> old = stress_at(before, p), now = stress_at(after, p);
    const Tensor<2> expected = R * in_plane(old) * R.transpose();
    largest = std::max(largest, old.norm());
    difference = std::max(difference, (in_plane(now) - expected).norm() + std::abs(now[2] - old[2]));
  }
  return difference / largest;
}

void check(double angle, int steps) {
  for (int nodes : {3, 6})
    for (StressUpdate update : {StressUpdate::SUBSTEPPED, StressUpdate::SINGLE, StressUpdate::FORWARD_EULER})
      for (StrainFrame frame : {StrainFrame::MIDPOINT, StrainFrame::END})
        for (double strain : {1e-3, 4e-3, 3e-2}) { // elastic, partly plastic, plastic
          UpdateOptions options;
          options.update = update;
          options.strain_frame = frame;
          Turned turned(nodes, options, strain);
          const WorkpieceState<2> before = turned.body.state();
          const double force = turned.body.internal_force().norm();
          for (int k = 1; k <= steps; ++k) turned.turn_to(angle * k / steps);
          EXPECT_LE(error(before, turned.body.state(), angle), 1e-10) << steps << " steps, strain " << strain;
          EXPECT_NEAR(turned.body.internal_force().norm() / force, 1, 1e-10);
          for (std::size_t p = 0; p < before.plastic.size(); ++p)
            EXPECT_NEAR(plastic_strain_eq_at(turned.body.state(), p), plastic_strain_eq_at(before, p), 1e-13);
        }
}

} // namespace

TEST(RigidRotation, RightAngleInAnyNumberOfSteps) {
  for (int steps : {1, 2, 3, 5, 6, 10, 90}) check(M_PI / 2, steps);
}

TEST(RigidRotation, TenStepsOfThreeTenths) { check(3.0, 10); }

TEST(RigidRotation, BackAndForth) { check(-2.0, 4); }
