#pragma once
// A tool that moves along a line as it turns about it.
#include "geometry/axis_frame.hpp"
#include "kinematics/coordinates.hpp"
#include "kinematics/rotation.hpp"

namespace burnish {

/// q = (phi), the angle [rad]: the tool turns by phi about the axis and goes along it by phi lead/(2 pi), a helix
/// for every point beside the axis. At phi = 0 its frame is that of space. Conjugate force on the tool, with f put
/// at a point of the axis and the moment M about it: Q_phi = lead/(2 pi) a . f + a . M [force length]. The carrier
/// goes along the axis only.
class Screw : public Coordinates<3> {
public:
  /// @param lead  advance along the axis of a full turn; negative: a left-hand thread; 0: a turn [length]
  /// @throws std::invalid_argument if it is not finite
  Screw(const AxisFrame& axis, double lead);

  const std::vector<std::string>& names() const override; ///< "phi"
  /// Pose at q, 1. @throws std::invalid_argument if q is not one finite number
  Pose<3> pose(const Eigen::VectorXd& q) const override;
  RigidMotion<3> carrier(const Eigen::VectorXd& q_from, const Eigen::VectorXd& q_to) const override;

private:
  Vector<3> m_point, m_advance; ///< of the axis; along it per radian
  AxisRotations m_turn;
};

} // namespace burnish
