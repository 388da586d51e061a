#include "kinematics/polar.hpp"
#include "base/error.hpp"
#include "geometry/plane.hpp"

namespace burnish {

Polar::Polar(const Vector<2>& pivot) : m_pivot(pivot) {
  require(pivot.allFinite(), "Polar", "pivot", pivot.transpose(), "finite components");
}

const std::vector<std::string>& Polar::names() const {
  static const std::vector<std::string> names{"r", "phi", "theta"};
  return names;
}

Pose<2> Polar::pose(const Eigen::VectorXd& q) const {
  require_coordinates("Polar::pose", names(), q);
  const double r = q(0), phi = q(1), theta = q(2);
  const Vector<2> e = plane_direction(phi);
  const Vector<2> e_phi = left_of(e);
  Pose<2> pose = blank_pose<2>(size());
  pose.origin = m_pivot + r * e;
  pose.origin_q[0] = e;
  pose.origin_q[1] = r * e_phi;
  pose.origin_qq[0][1] = pose.origin_qq[1][0] = e_phi;
  pose.origin_qq[1][1] = -r * e;
  pose.R = plane_rotation(theta);
  pose.R_q[2] = plane_rotation_derivative(pose.R);
  pose.R_qq[2][2] = -pose.R;
  return pose;
}

RigidMotion<2> Polar::carrier(const Eigen::VectorXd& q_from, const Eigen::VectorXd& q_to) const {
  require_coordinates("Polar::carrier", names(), q_from);
  require_coordinates("Polar::carrier", names(), q_to);
  const Tensor<2> turn = plane_rotation(q_to(1) - q_from(1));
  return {turn, m_pivot - turn * m_pivot};
}

} // namespace burnish
