#include "kinematics/tool.hpp"
#include "base/error.hpp"
#include <cassert>
#include <utility>

namespace burnish {

template <int Dim>
Tool<Dim>::Tool(std::string name, std::shared_ptr<const Profile<Dim>> profile,
                std::shared_ptr<const Coordinates<Dim>> coordinates)
    : m_name(std::move(name)), m_profile(std::move(profile)), m_coordinates(std::move(coordinates)) {
  if (m_name.empty()) fail("Tool", "the name is empty");
  if (!m_profile) fail("Tool", "tool \"" + m_name + "\" has no profile (null pointer)");
  if (!m_coordinates) fail("Tool", "tool \"" + m_name + "\" has no coordinates (null pointer)");
}

template <int Dim> SurfacePoint<Dim> Tool<Dim>::surface(const Eigen::VectorXd& q, const Param<Dim>& s) const {
  require_coordinates("Tool::surface of \"" + m_name + "\"", m_coordinates->names(), q);
  return surface(m_coordinates->pose(q), s);
}

template <int Dim> SurfacePoint<Dim> Tool<Dim>::surface(const Pose<Dim>& pose, const Param<Dim>& s) const {
  const auto count = pose.origin_q.size();
  assert(count == static_cast<std::size_t>(m_coordinates->size()) && pose.R_q.size() == count);
  const ProfilePoint<Dim> local = m_profile->evaluate(s);
  SurfacePoint<Dim> point;
  // along the profile
  point.x = pose.origin + pose.R * local.x;
  point.n = pose.R * local.n;
  point.x_s = pose.R * local.x_s;
  point.n_s = pose.R * local.n_s;
  const auto size = static_cast<Eigen::Index>(count);
  for (std::size_t a = 0; a < Dim - 1; ++a) {
    point.x_ss[a] = pose.R * local.x_ss[a];
    point.x_qs[a].resize(Dim, size);
  }
  // by the coordinates
  point.x_q.resize(Dim, size);
  point.n_q.resize(Dim, size);
  point.x_qq.assign(count, PerCoordinate<Dim>(Dim, size));
  for (std::size_t k = 0; k < count; ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    point.x_q.col(column) = pose.origin_q[k] + pose.R_q[k] * local.x;
    point.n_q.col(column) = pose.R_q[k] * local.n;
    for (std::size_t a = 0; a < Dim - 1; ++a)
      point.x_qs[a].col(column) = pose.R_q[k] * local.x_s.col(static_cast<Eigen::Index>(a));
    for (std::size_t l = 0; l < count; ++l)
      point.x_qq[k].col(static_cast<Eigen::Index>(l)) = pose.origin_qq[k][l] + pose.R_qq[k][l] * local.x;
  }
  return point;
}

template <int Dim>
ClosestPoint<Dim> Tool<Dim>::closest_point(const Pose<Dim>& pose, const Vector<Dim>& x,
                                           const Param<Dim>& near) const {
  return m_profile->closest_point(pose.R.transpose() * (x - pose.origin), near);
}

template class Tool<2>;

} // namespace burnish
