#pragma once
// Polar coordinates of a plane tool about a fixed pivot (METHOD.md (2.2)).
#include "kinematics/coordinates.hpp"

namespace burnish {

/// q = (r, phi, theta): origin = pivot + r e(phi), r [length], phi [rad, counter-clockwise from the x axis];
/// theta = ABSOLUTE rotation of the tool's frame [rad]: a change of phi alone moves the tool, no spin.
/// Conjugate forces on the tool:
///   Q_r      along e(phi), positive away from the pivot [force]
///   Q_phi    moment about the pivot of the force put at the frame's origin [force length]
///   Q_theta  moment about the frame's origin [force length]
/// so that the moment of the true force about the pivot is Q_phi + Q_theta.
/// Any finite r is accepted; at r = 0 the coordinate phi moves nothing (singular under force control).
class Polar : public Coordinates<2> {
public:
  /// @param pivot  fixed point, 2 [length]
  /// @throws std::invalid_argument if pivot is not finite
  explicit Polar(const Vector<2>& pivot = Vector<2>::Zero());
  const Vector<2>& pivot() const { return m_pivot; }

  /// "r", "phi", "theta".
  const std::vector<std::string>& names() const override;
  /// Pose at q, 3. Nonzero derivatives, with e = e(phi): origin_r = e, origin_phi = r e', origin_r,phi = e',
  /// origin_phi,phi = -r e; R_theta = R', R_theta,theta = -R.
  /// @throws std::invalid_argument if q is not 3 finite numbers
  Pose<2> pose(const Eigen::VectorXd& q) const override;
  /// Turn about the pivot by phi_to - phi_from. The change of r is NOT part of it (the carrier is rigid and
  /// is meant for the path along the workpiece, r for the approach), nor is theta.
  /// @throws std::invalid_argument if q_from or q_to is not 3 finite numbers
  RigidMotion<2> carrier(const Eigen::VectorXd& q_from, const Eigen::VectorXd& q_to) const override;

private:
  Vector<2> m_pivot;
};

} // namespace burnish
