#include "kinematics/cartesian.hpp"
#include "geometry/plane.hpp"

namespace burnish {

const std::vector<std::string>& Cartesian::names() const {
  static const std::vector<std::string> names{"x", "y", "angle"};
  return names;
}

Pose<2> Cartesian::pose(const Eigen::VectorXd& q) const {
  require_coordinates("Cartesian::pose", names(), q);
  Pose<2> pose = blank_pose<2>(size());
  pose.origin = q.head<2>();
  pose.origin_q[0] = Vector<2>::UnitX();
  pose.origin_q[1] = Vector<2>::UnitY();
  pose.R = plane_rotation(q(2));
  pose.R_q[2] = plane_rotation_derivative(pose.R);
  pose.R_qq[2][2] = -pose.R;
  return pose;
}

} // namespace burnish
