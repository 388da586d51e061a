#include "kinematics/tool.hpp"
#include "base/error.hpp"
#include <cassert>
#include <utility>

namespace burnish {

namespace {

// What the growth of the tool adds to the derivatives, METHOD.md (2.18). @param y place, of the present size [length]
template <int Dim> void add_growth(const Pose<Dim>& pose, const Vector<Dim>& y, SurfacePoint<Dim>& point) {
  point.growth = pose.size_q.transpose() / pose.size;
  const Vector<Dim> along = pose.R * y;
  for (Eigen::Index k = 0; k < point.growth.size(); ++k) {
    PerCoordinate<Dim>& x_kq = point.x_qq[static_cast<std::size_t>(k)];
    point.x_q.col(k) += point.growth[k] * along;
    for (Eigen::Index l = 0; l < point.growth.size(); ++l)
      x_kq.col(l) += point.growth[k] * (pose.R_q[static_cast<std::size_t>(l)] * y) +
                     point.growth[l] * (pose.R_q[static_cast<std::size_t>(k)] * y) +
                     pose.size_qq(k, l) / pose.size * along;
  }
}

} // namespace

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
  point.B = local.B / pose.size;
  point.size = pose.size;
  const Vector<Dim> y = pose.size * place.y;
  const auto size = static_cast<Eigen::Index>(count);
  point.x_q.resize(Dim, size);
  point.n_q.resize(Dim, size);
  for (auto& E_q : point.E_q) E_q.resize(Dim, size);
  point.x_qq.assign(count, PerCoordinate<Dim>(Dim, size));
  for (std::size_t k = 0; k < count; ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    point.x_q.col(column) = pose.origin_q[k] + pose.R_q[k] * y;
    point.n_q.col(column) = pose.R_q[k] * local.n;
    for (std::size_t a = 0; a < point.E_q.size(); ++a)
      point.E_q[a].col(column) = pose.R_q[k] * local.E.col(static_cast<Eigen::Index>(a));
    for (std::size_t l = 0; l < count; ++l)
      point.x_qq[k].col(static_cast<Eigen::Index>(l)) = pose.origin_qq[k][l] + pose.R_qq[k][l] * y;
  }
  if (pose.size_q.size() > 0) add_growth(pose, y, point);
  return point;
}

template <int Dim>
SurfaceFoot<Dim> Tool<Dim>::foot(const Pose<Dim>& pose, const Vector<Dim>& x, const Param<Dim>& hint) const {
  SurfaceFoot<Dim> foot = m_surface->foot(pose.R.transpose() * (x - pose.origin) / pose.size, hint);
  foot.gap *= pose.size;
  return foot;
}

template class Tool<2>;
template class Tool<3>;

} // namespace burnish
