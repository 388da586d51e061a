#include "kinematics/cartesian_in_space.hpp"
#include "kinematics/rotation.hpp"

namespace burnish {

const std::vector<std::string>& CartesianInSpace::names() const {
  static const std::vector<std::string> names{"x", "y", "z", "spinx", "spiny", "spinz"};
  return names;
}

Pose<3> CartesianInSpace::pose(const Eigen::VectorXd& q) const {
  require_coordinates("CartesianInSpace::pose", names(), q);
  Pose<3> pose = blank_pose<3>(size());
  pose.origin = q.head<3>();
  const RotationValue<3> rotation = VectorRotation().at(q.tail<3>());
  pose.R = rotation.R;
  for (std::size_t k = 0; k < 3; ++k) {
    pose.origin_q[k] = Vector<3>::Unit(static_cast<Eigen::Index>(k));
    pose.R_q[3 + k] = rotation.first[k];
    for (std::size_t l = 0; l < 3; ++l) pose.R_qq[3 + k][3 + l] = rotation.second[k][l];
  }
  return pose;
}

} // namespace burnish
