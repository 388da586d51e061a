#include "kinematics/cartesian_in_space.hpp"
#include "base/error.hpp"
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
  const RotationValue<3> rotation = VectorRotation().at(q.tail<3>() - m_spin);
  const Tensor<3> turned = m_turned.toRotationMatrix();
  pose.R = rotation.R * turned;
  for (std::size_t k = 0; k < 3; ++k) {
    pose.origin_q[k] = Vector<3>::Unit(static_cast<Eigen::Index>(k));
    pose.R_q[3 + k] = rotation.first[k] * turned;
    for (std::size_t l = 0; l < 3; ++l) pose.R_qq[3 + k][3 + l] = rotation.second[k][l] * turned;
  }
  return pose;
}

Eigen::VectorXd CartesianInSpace::reference() const {
  Eigen::VectorXd reference(7);
  reference << m_spin, m_turned.w(), m_turned.vec();
  return reference;
}

Eigen::VectorXd CartesianInSpace::reference_at(const Eigen::VectorXd& q) const {
  require_coordinates("CartesianInSpace::reference_at", names(), q);
  const Vector<3> v = q.tail<3>() - m_spin;
  const double angle = v.norm();
  Eigen::Quaterniond turned = m_turned;
  if (angle > 0) turned = Eigen::Quaterniond(Eigen::AngleAxisd(angle, v / angle)) * m_turned;
  turned.normalize();
  Eigen::VectorXd reference(7);
  reference << q.tail<3>(), turned.w(), turned.vec();
  return reference;
}

void CartesianInSpace::refer_to(const Eigen::VectorXd& reference) const {
  require(reference.size() == 7, "CartesianInSpace::refer_to", "size of the reference", reference.size(),
          "7");
  m_spin = reference.head<3>();
  m_turned = Eigen::Quaterniond(reference[3], reference[4], reference[5], reference[6]);
}

} // namespace burnish
