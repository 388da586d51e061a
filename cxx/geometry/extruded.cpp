#include "geometry/extruded.hpp"
#include "base/error.hpp"
#include "geometry/refined_outline.hpp"
#include "geometry/spread.hpp"
#include <algorithm>

namespace burnish {

Extruded::Extruded(std::shared_ptr<const Profile<2>> profile, const AxisFrame& frame, double length)
    : m_section(std::move(profile)), m_frame(frame), m_length(length) {
  require(length > 0, "Extruded", "length", length, "> 0");
}

SurfacePlace<3> Extruded::swept(const SurfacePlace<2>& place, double along) const {
  return {m_frame.global(Vector<3>(place.y[0], place.y[1], along)), Param<3>(place.hint[0], along)};
}

SurfaceFoot<3> Extruded::foot(const Vector<3>& p, const Param<3>& hint) const {
  constexpr double end_itself = 1e-12; // of the length
  require(p.allFinite(), "Extruded::foot", "p", p.transpose(), "finite components");
  require(hint.allFinite(), "Extruded::foot", "hint", hint.transpose(), "finite parameters");
  const Vector<3> local = m_frame.local(p);
  const SurfaceFoot<2> flat = m_section.foot(local.head<2>(), Param<2>(hint[0]));
  const double along = endless() ? local[2] : std::clamp(local[2], 0., m_length),
               excess = std::abs(local[2] - along);
  SurfaceFoot<3> foot{swept(flat.place, along), flat.gap, flat.on_end};
  if (endless() || excess <= end_itself * m_length) return foot;
  foot.on_end = true;
  foot.gap = (p - foot.place.y).norm();
  return foot;
}

SurfaceFrame<3> Extruded::frame(const SurfacePlace<3>& place) const {
  const SurfaceFrame<2> section = m_section.frame(section_place(place));
  SurfaceFrame<3> frame;
  frame.n = m_frame.base.leftCols<2>() * section.n;
  frame.E.col(0) = m_frame.base.leftCols<2>() * section.E;
  frame.E.col(1) = frame.n.cross(frame.E.col(0));
  frame.B << section.B(0), 0, 0, 0;
  return frame;
}

std::vector<SurfacePlace<3>> Extruded::ends() const {
  std::vector<SurfacePlace<3>> places;
  if (!endless())
    for (const double along : {0., m_length})
      for (const auto& place : m_section.outline(RIM_PLACES)) places.push_back(swept(place, along));
  for (const auto& end : m_section.ends())
    for (int i = 0; i < RIM_PLACES; ++i) places.push_back(swept(end, way(i / (RIM_PLACES - 1.))));
  return places;
}

double Extruded::distance_to_end(const SurfacePlace<3>& place) const {
  const double beside = m_section.distance_to_end(section_place(place));
  if (endless()) return beside;
  const double along = m_frame.local(place.y)[2];
  return std::min({along, m_length - along, beside});
}

std::vector<SurfacePlace<3>> Extruded::samples(int n) const {
  std::vector<SurfacePlace<3>> places;
  for (const auto& place : m_section.samples(n))
    places.push_back(swept(place, way(spread(static_cast<int>(places.size())))));
  return places;
}

std::vector<SurfacePlace<3>> Extruded::outline(int n) const {
  std::vector<SurfacePlace<3>> places;
  for (const auto& place : m_section.outline(n)) places.push_back(swept(place, way(0.5)));
  return places;
}

SurfaceMesh Extruded::mesh(const Eigen::AlignedBox3d& window) const {
  const auto allowed = [&](const Vector<2>&, const Vector<2>&) {
    return MESH_SAGITTA * window.sizes().maxCoeff();
  };
  double begin = 0, end = m_length;
  if (endless()) {
    const double reach = 0.5 * window.diagonal().norm();
    begin = m_frame.local(window.center())[2] - reach;
    end = begin + 2 * reach;
  }
  std::vector<std::vector<SurfacePlace<3>>> rows;
  for (const auto& place : refined_outline<2>(m_section, MESH_PLACES, allowed))
    rows.push_back({swept(place, begin), swept(place, end)});
  SurfaceMesh mesh;
  add_rows(mesh, *this, rows);
  return mesh;
}

} // namespace burnish
