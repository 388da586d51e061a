#include "kinematics/screw.hpp"
#include "base/error.hpp"

namespace burnish {

Screw::Screw(const AxisFrame& axis, double lead)
    : m_point(axis.point), m_advance(lead / (2 * M_PI) * axis.base.col(2)), m_turn({axis.base.col(2)}) {
  require(std::isfinite(lead), "Screw", "lead", lead, "a finite number");
}

const std::vector<std::string>& Screw::names() const {
  static const std::vector<std::string> names{"phi"};
  return names;
}

Pose<3> Screw::pose(const Eigen::VectorXd& q) const {
  require_coordinates("Screw::pose", names(), q);
  const RotationValue<3> turn = m_turn.at(q);
  Pose<3> pose = blank_pose<3>(1);
  pose.R = turn.R;
  pose.R_q[0] = turn.first[0];
  pose.R_qq[0][0] = turn.second[0][0];
  pose.origin = m_point + q[0] * m_advance - turn.R * m_point;
  pose.origin_q[0] = m_advance - turn.first[0] * m_point;
  pose.origin_qq[0][0] = -turn.second[0][0] * m_point;
  return pose;
}

RigidMotion<3> Screw::carrier(const Eigen::VectorXd& q_from, const Eigen::VectorXd& q_to) const {
  require_coordinates("Screw::carrier", names(), q_from);
  require_coordinates("Screw::carrier", names(), q_to);
  return {Tensor<3>::Identity(), (q_to[0] - q_from[0]) * m_advance};
}

} // namespace burnish
