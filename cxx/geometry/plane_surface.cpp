#include "geometry/plane_surface.hpp"
#include "base/error.hpp"
#include "geometry/spread.hpp"

namespace burnish {

PlaneSurface::PlaneSurface(const Vector<3>& point, const Vector<3>& normal, double size)
    : m_frame(axis_frame("PlaneSurface", point, normal)), m_size(size) {
  require(std::isfinite(size) && size > 0, "PlaneSurface", "size", size, "a finite number > 0");
}

SurfaceFoot<3> PlaneSurface::foot(const Vector<3>& p, const Param<3>& hint) const {
  require(p.allFinite(), "PlaneSurface::foot", "p", p.transpose(), "finite components");
  const Vector<3> n = m_frame.base.col(2);
  const double gap = n.dot(p - m_frame.point);
  return {{p - gap * n, hint}, gap, false};
}

SurfaceFrame<3> PlaneSurface::frame(const SurfacePlace<3>&) const {
  return {m_frame.base.col(2), m_frame.base.leftCols<2>(), Curvature<3>::Zero()};
}

std::vector<SurfacePlace<3>> PlaneSurface::samples(int n) const {
  std::vector<SurfacePlace<3>> places;
  for (int i = 0; i < n; ++i)
    places.push_back(
        {m_frame.global(m_size * Vector<3>((i + 0.5) / n - 0.5, spread(i) - 0.5, 0)), Param<3>::Zero()});
  return places;
}

std::vector<SurfacePlace<3>> PlaneSurface::outline(int n) const {
  std::vector<SurfacePlace<3>> places;
  for (int i = 0; i < n; ++i)
    places.push_back({m_frame.global(m_size * Vector<3>(i / (n - 1.) - 0.5, 0, 0)), Param<3>::Zero()});
  return places;
}

SurfaceMesh PlaneSurface::mesh(const Eigen::AlignedBox3d& window) const {
  Eigen::AlignedBox2d patch;
  for (int corner = 0; corner < 8; ++corner)
    patch.extend(Vector<2>(
        m_frame.local(window.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner))).head<2>()));
  const auto at = [&](double x, double y) -> SurfacePlace<3> {
    return {m_frame.global(Vector<3>(x, y, 0)), Param<3>::Zero()};
  };
  SurfaceMesh mesh;
  add_rows(mesh, *this,
           {{at(patch.min()[0], patch.min()[1]), at(patch.max()[0], patch.min()[1])},
            {at(patch.min()[0], patch.max()[1]), at(patch.max()[0], patch.max()[1])}});
  return mesh;
}

} // namespace burnish
