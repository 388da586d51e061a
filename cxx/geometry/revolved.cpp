#include "geometry/revolved.hpp"
#include "base/error.hpp"
#include "geometry/plane.hpp"
#include "geometry/refined_outline.hpp"
#include "geometry/spread.hpp"
#include <algorithm>

namespace burnish {
namespace {

constexpr int OUTLINE = 257;                            // places at which the profile is looked at
constexpr double LEAST_ANGLES = 60, MOST_ANGLES = 1440; // of a mesh
constexpr double ON_AXIS = 1e-6;       // of the largest distance from the axis: n_r/r is 0/0 there
constexpr double ALONG_AXIS = 1e-6;    // radial part of a normal at a pole: what a file's digits can cost
constexpr double MIRROR_DIGITS = 1e-6; // of the largest distance from the axis, for the mirror image

} // namespace

Revolved::Revolved(std::shared_ptr<const Profile<2>> profile, const AxisFrame& axis, double radius)
    : m_meridian(std::move(profile)), m_axis(axis), m_radius(radius),
      m_tightest(m_meridian.tightest_radius()) {
  require(std::isfinite(radius) && radius >= 0, "Revolved", "radius", radius, "a finite number >= 0");
  const auto places = m_meridian.outline(OUTLINE);
  for (const auto& place : places) m_largest = std::max(m_largest, distance(place));
  check_mirror(places);
  require(m_largest > 0, "Revolved", "largest distance from the axis", m_largest, "> 0");
  for (const auto& end : m_meridian.ends())
    if (!at_pole(distance(end), m_meridian.frame(end))) m_ends.push_back(end);
  for (const auto& place : places)
    m_tightest =
        std::min(m_tightest, 1 / std::abs(curvature_around(distance(place), m_meridian.frame(place))));
}

void Revolved::check_mirror(const std::vector<SurfacePlace<2>>& places) const {
  for (const auto& place : places) {
    const double r = distance(place), allowed = MIRROR_DIGITS * m_largest;
    if (r >= -allowed) continue;
    const auto foot = m_meridian.foot(place.y - Vector<2>(2 * r, 0), place.hint);
    if (std::abs(foot.gap) <= allowed) continue;
    std::ostringstream what;
    what << "the profile has a point at r = " << r << ", y = " << place.y[1]
         << " and not its mirror image, expected r >= 0 or both sides alike";
    fail("Revolved", what.str());
  }
}

// Whether the surface is smooth on the axis: next to it n_r = k r then.
bool Revolved::at_pole(double r, const SurfaceFrame<2>& meridian) const {
  return std::abs(r) <= ON_AXIS * m_largest &&
         std::abs(meridian.n[0]) <= ALONG_AXIS + 2 * std::abs(meridian.B(0) * r);
}

// n_r/r; at a pole it is the curvature of the meridian, at an apex as large as it gets.
double Revolved::curvature_around(double r, const SurfaceFrame<2>& meridian) const {
  if (at_pole(r, meridian)) return meridian.B(0);
  return meridian.n[0] / std::copysign(std::max(std::abs(r), ON_AXIS * m_largest), r);
}

SurfacePlace<2> Revolved::meridian_place(const SurfacePlace<3>& place) const {
  return m_meridian.at(place.hint[0]);
}

SurfacePlace<3> Revolved::turned(const SurfacePlace<2>& place, double angle) const {
  const Vector<2> around = distance(place) * plane_direction(angle);
  return {m_axis.global(Vector<3>(around[0], around[1], place.y[1])), Param<3>(place.hint[0], angle)};
}

SurfaceFoot<3> Revolved::foot(const Vector<3>& p, const Param<3>& hint) const {
  require(p.allFinite(), "Revolved::foot", "p", p.transpose(), "finite components");
  require(hint.allFinite(), "Revolved::foot", "hint", hint.transpose(), "finite parameters");
  const Vector<3> local = m_axis.local(p);
  const double r = local.head<2>().norm();
  SurfaceFoot<2> flat = m_meridian.foot({r - m_radius, local[2]}, Param<2>(hint[0]));
  if (flat.on_end && at_pole(distance(flat.place), m_meridian.frame(flat.place))) { // by rounding: no end
    flat.on_end = false;
    flat.gap = m_meridian.frame(flat.place).n[1] * (local[2] - flat.place.y[1]);
  }
  // on the axis every half-plane is equally near: stay where the node was
  const double angle = r > 0 ? std::atan2(local[1], local[0]) : hint[1];
  SurfaceFoot<3> foot{turned(flat.place, angle), flat.gap, flat.on_end};
  if (r > 0) { // without the rounding of the angle
    const Vector<2> around = distance(flat.place) * (local.head<2>() / r);
    foot.place.y = m_axis.global(Vector<3>(around[0], around[1], flat.place.y[1]));
  }
  return foot;
}

SurfaceFrame<3> Revolved::frame(const SurfacePlace<3>& place) const {
  const SurfacePlace<2> flat = meridian_place(place);
  const SurfaceFrame<2> meridian = m_meridian.frame(flat);
  const Vector<2> around = m_axis.local(place.y).head<2>();
  const double r = distance(flat), along = around.norm();
  Vector<2> e = along > 0 ? Vector<2>(around / along) : plane_direction(place.hint[1]);
  if (r < 0 && along > 0) e = -e; // the mirror image: the profile's r runs the other way
  const auto in_space = [&](const Vector<2>& v) -> Vector<3> {
    return m_axis.base * Vector<3>(v[0] * e[0], v[0] * e[1], v[1]);
  };
  SurfaceFrame<3> frame;
  frame.n = in_space(meridian.n);
  frame.E.col(0) = in_space(meridian.E);
  frame.E.col(1) = frame.n.cross(frame.E.col(0));
  frame.B << meridian.B(0), 0, 0, curvature_around(r, meridian);
  return frame;
}

bool Revolved::closed() const { return m_ends.empty(); }

std::vector<SurfacePlace<3>> Revolved::ends() const {
  std::vector<SurfacePlace<3>> places;
  for (const auto& end : m_ends) {
    const double r = distance(end), apex = ON_AXIS * m_largest;
    if (r < -apex) continue; // the mirror image
    for (int i = 0; i < (r <= apex ? 1 : RIM_PLACES); ++i)
      places.push_back(turned(end, 2 * M_PI * i / RIM_PLACES));
  }
  return places;
}

double Revolved::distance_to_end(const SurfacePlace<3>& place) const {
  const SurfacePlace<2> flat = meridian_place(place);
  double distance = std::numeric_limits<double>::infinity();
  for (const auto& end : m_ends) distance = std::min(distance, m_meridian.slip(end, flat).norm());
  return distance;
}

std::vector<SurfacePlace<3>> Revolved::samples(int n) const {
  std::vector<SurfacePlace<3>> places;
  for (const auto& place : m_meridian.samples(n))
    places.push_back(turned(place, 2 * M_PI * spread(static_cast<int>(places.size()))));
  return places;
}

std::vector<SurfacePlace<3>> Revolved::outline(int n) const {
  std::vector<SurfacePlace<3>> places;
  for (const auto& place : m_meridian.outline(n)) places.push_back(turned(place, 0));
  return places;
}

// Half of what is allowed is left to the profile, half to the circles.
SurfaceMesh Revolved::mesh(const Eigen::AlignedBox3d& window) const {
  const double sagitta = 0.5 * MESH_SAGITTA * window.sizes().maxCoeff();
  const double step = std::acos(std::max(1 - sagitta / m_largest, 0.)) * 2;
  const int count = static_cast<int>(std::ceil(std::clamp(2 * M_PI / step, LEAST_ANGLES, MOST_ANGLES)));
  std::vector<std::vector<SurfacePlace<3>>> rows;
  const auto allowed = [&](const Vector<2>&, const Vector<2>&) { return sagitta; };
  for (const auto& place : refined_outline<2>(m_meridian, MESH_PLACES, allowed)) {
    if (distance(place) < -ON_AXIS * m_largest) continue; // the mirror image
    rows.emplace_back();
    for (int i = 0; i <= count; ++i) rows.back().push_back(turned(place, 2 * M_PI * i / count));
  }
  SurfaceMesh mesh;
  add_rows(mesh, *this, rows);
  return mesh;
}

} // namespace burnish
