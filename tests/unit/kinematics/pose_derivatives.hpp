#pragma once
// Derivatives of a pose against finite differences.
#include "kinematics/coordinates.hpp"
#include "unit/finite_difference.hpp"

namespace burnish::test {

/// Every first and second derivative of the pose at q, lengths and angles about 1, to 1e-10.
template <int Dim>
void check_pose_derivatives(const Coordinates<Dim>& coordinates, const Eigen::VectorXd& q) {
  const Pose<Dim> pose = coordinates.pose(q);
  for (int k = 0; k < coordinates.size(); ++k) {
    SCOPED_TRACE("coordinate " + coordinates.names()[k]);
    const auto moved = [&](double t) {
      Eigen::VectorXd q_moved = q;
      q_moved(k) = t;
      return coordinates.pose(q_moved);
    };
    const auto check = [&](const auto& member, const auto& derivative) {
      const auto expected = finite_difference([&](double t) { return member(moved(t)); }, q(k), 1e-3);
      expect_close(derivative, expected, 1, 1e-10, "derivative");
    };
    check([](const Pose<Dim>& p) { return p.origin; }, pose.origin_q[k]);
    check([](const Pose<Dim>& p) { return p.R; }, pose.R_q[k]);
    for (int l = 0; l < coordinates.size(); ++l) {
      check([l](const Pose<Dim>& p) { return p.origin_q[l]; }, pose.origin_qq[l][k]);
      check([l](const Pose<Dim>& p) { return p.R_q[l]; }, pose.R_qq[l][k]);
    }
  }
}

} // namespace burnish::test
