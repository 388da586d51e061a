#include "kinematics/tool.hpp"
#include "base/error.hpp"
#include <cassert>
#include <utility>

namespace burnish {

template <int Dim>
Tool<Dim>::Tool(std::string name, std::shared_ptr<const Surface<Dim>> surface,
                std::shared_ptr<const Coordinates<Dim>> coordinates)
    : m_name(std::move(name)), m_surface(std::move(surface)), m_coordinates(std::move(coordinates)) {
  if (m_name.empty()) fail("Tool", "the name is empty");
  if (!m_surface) fail("Tool", "tool \"" + m_name + "\" has no surface (null pointer)");
  if (!m_coordinates) fail("Tool", "tool \"" + m_name + "\" has no coordinates (null pointer)");
}

template <int Dim>
SurfacePoint<Dim> Tool<Dim>::point(const Eigen::VectorXd& q, const SurfacePlace<Dim>& place) const {
  require_coordinates("Tool::point of \"" + m_name + "\"", m_coordinates->names(), q);
  return point(m_coordinates->pose(q), place);
}

template <int Dim>
SurfacePoint<Dim> Tool<Dim>::point(const Pose<Dim>& pose, const SurfacePlace<Dim>& place) const {
  const auto count = pose.origin_q.size();
  assert(count == static_cast<std::size_t>(m_coordinates->size()) && pose.R_q.size() == count);
  const SurfaceFrame<Dim> local = m_surface->frame(place);
  SurfacePoint<Dim> point;
  point.x = position(pose, place);
  point.n = pose.R * local.n;
  point.E = pose.R * local.E;
  point.B = local.B;
  const auto size = static_cast<Eigen::Index>(count);
  point.x_q.resize(Dim, size);
  point.n_q.resize(Dim, size);
  for (auto& E_q : point.E_q) E_q.resize(Dim, size);
  point.x_qq.assign(count, PerCoordinate<Dim>(Dim, size));
  for (std::size_t k = 0; k < count; ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    point.x_q.col(column) = pose.origin_q[k] + pose.R_q[k] * place.y;
    point.n_q.col(column) = pose.R_q[k] * local.n;
    for (std::size_t a = 0; a < point.E_q.size(); ++a)
      point.E_q[a].col(column) = pose.R_q[k] * local.E.col(static_cast<Eigen::Index>(a));
    for (std::size_t l = 0; l < count; ++l)
      point.x_qq[k].col(static_cast<Eigen::Index>(l)) = pose.origin_qq[k][l] + pose.R_qq[k][l] * place.y;
  }
  return point;
}

template <int Dim>
SurfaceFoot<Dim> Tool<Dim>::foot(const Pose<Dim>& pose, const Vector<Dim>& x, const Param<Dim>& hint) const {
  return m_surface->foot(pose.R.transpose() * (x - pose.origin), hint);
}

template class Tool<2>;
template class Tool<3>;

} // namespace burnish
