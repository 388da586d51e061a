#pragma once
// Cartesian coordinates of a plane tool: position of its frame and absolute rotation.
#include "kinematics/coordinates.hpp"

namespace burnish {

/// q = (x, y, angle): origin = (x, y) [length], R = rotation by angle [rad, counter-clockwise].
/// Conjugate forces on the tool: Q_x, Q_y [force], Q_angle = moment about the frame's origin [force length].
/// The carrier is the default one, the translation of the origin.
class Cartesian : public Coordinates<2> {
public:
  /// "x", "y", "angle".
  const std::vector<std::string>& names() const override;
  /// Pose at q, 3. Nonzero derivatives: origin_x, origin_y (unit vectors), R_angle = R', R_angle,angle = -R.
  /// @throws std::invalid_argument if q is not 3 finite numbers
  Pose<2> pose(const Eigen::VectorXd& q) const override;
};

} // namespace burnish
