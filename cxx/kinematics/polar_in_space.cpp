#include "kinematics/polar_in_space.hpp"
#include <array>

namespace burnish {
namespace {

constexpr std::array<std::size_t, 3> PLANE{0, 1, 3}; // where r, phi, theta are

Eigen::VectorXd plane_part(const Eigen::VectorXd& q) { return Vector<3>(q[0], q[1], q[3]); }

} // namespace

const std::vector<std::string>& PolarInSpace::names() const {
  static const std::vector<std::string> names{"r", "phi", "z", "theta"};
  return names;
}

Pose<3> PolarInSpace::pose(const Eigen::VectorXd& q) const {
  require_coordinates("PolarInSpace::pose", names(), q);
  const Pose<2> flat = m_plane.pose(plane_part(q));
  const Vector<3> a = m_axis.base.col(2);
  Pose<3> pose = blank_pose<3>(size());
  pose.origin = m_axis.point + in_space(flat.origin) + q[2] * a;
  pose.origin_q[2] = a;
  pose.R = in_space(flat.R) + a * a.transpose();
  for (std::size_t k = 0; k < 3; ++k) {
    pose.origin_q[PLANE[k]] = in_space(flat.origin_q[k]);
    pose.R_q[PLANE[k]] = in_space(flat.R_q[k]);
    for (std::size_t l = 0; l < 3; ++l) {
      pose.origin_qq[PLANE[k]][PLANE[l]] = in_space(flat.origin_qq[k][l]);
      pose.R_qq[PLANE[k]][PLANE[l]] = in_space(flat.R_qq[k][l]);
    }
  }
  return pose;
}

RigidMotion<3> PolarInSpace::carrier(const Eigen::VectorXd& q_from, const Eigen::VectorXd& q_to) const {
  require_coordinates("PolarInSpace::carrier", names(), q_from);
  require_coordinates("PolarInSpace::carrier", names(), q_to);
  const Vector<3> a = m_axis.base.col(2);
  const RigidMotion<2> flat = m_plane.carrier(plane_part(q_from), plane_part(q_to));
  const Tensor<3> turn = in_space(flat.R) + a * a.transpose();
  return {turn, m_axis.point - turn * m_axis.point + (q_to[2] - q_from[2]) * a};
}

} // namespace burnish
