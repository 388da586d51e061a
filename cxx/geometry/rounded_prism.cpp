#include "geometry/rounded_prism.hpp"
#include "base/error.hpp"
#include "geometry/polygon.hpp"
#include "geometry/refined_outline.hpp"
#include "geometry/spread.hpp"

namespace burnish {
namespace {

constexpr int SECTION_PLACES = 257;      // places at which the section is looked at
constexpr double FILLET_ROUNDING = 1e-9; // of the fillet

double length_checked(double value, const char* name) {
  require(std::isfinite(value) && value > 0, "RoundedPrism", name, value, "a finite number > 0");
  return value;
}

} // namespace

RoundedPrism::RoundedPrism(std::shared_ptr<const Profile<2>> section, const AxisFrame& frame, double length,
                           double fillet, bool inside)
    : m_section(std::move(section)), m_frame(frame), m_fillet(length_checked(fillet, "fillet")),
      m_inner(length_checked(length, "length") / 2 - fillet), m_side(inside ? -1 : 1) {
  if (!m_section.closed()) fail("RoundedPrism", "the section is open, expected a closed one");
  if (m_inner < -FILLET_ROUNDING * fillet)
    require(false, "RoundedPrism", "fillet", fillet, "up to half the length");
  m_inner = std::max(m_inner, 0.);
  check_fillet();
}

// A circle of the fillet's radius rolls along the section from within and touches it at one place at a time.
void RoundedPrism::check_fillet() const {
  for (const auto& place : m_section.outline(SECTION_PLACES)) {
    const Vector<2> inner = place.y - m_fillet * m_section.frame(place).n;
    const double gap = m_section.foot(inner, place.hint).gap;
    if (gap <= -m_fillet * (1 - FILLET_ROUNDING)) continue;
    std::ostringstream what;
    what << "a fillet of radius " << m_fillet << " does not fit into the section at (" << place.y[0] << ", "
         << place.y[1] << ")";
    fail("RoundedPrism", what.str());
  }
}

RoundedPrism::Seen RoundedPrism::seen(const Vector<3>& local, const Param<3>& hint) const {
  const SurfaceFoot<2> flat = m_section.foot(local.head<2>(), Param<2>(hint[0]));
  const double height = local[2] != 0 ? local[2] : hint[1];
  return {flat.place, flat.gap, flat.gap + m_fillet, std::abs(local[2]) - m_inner, std::copysign(1., height)};
}

SurfaceFoot<3> RoundedPrism::foot(const Vector<3>& p, const Param<3>& hint) const {
  require(p.allFinite(), "RoundedPrism::foot", "p", p.transpose(), "finite components");
  require(hint.allFinite(), "RoundedPrism::foot", "hint", hint.transpose(), "finite parameters");
  const Vector<3> local = m_frame.local(p);
  const Seen see = seen(local, hint);
  const Vector<2>& wall = see.place.y;
  const double s = see.place.hint[0], end_gap = see.along - m_fillet;
  const bool edge = see.out > 0 && see.along > 0;
  if (edge) {
    const Vector<2> n = m_section.frame(see.place).n;
    const double distance = std::hypot(see.out, see.along), part = m_fillet / distance;
    const Vector<2> y = wall + (see.out * part - m_fillet) * n;
    return {at(y, see.end * (m_inner + see.along * part), s), m_side * (distance - m_fillet), false};
  }
  if (see.out > 0 || (see.along <= 0 && see.gap >= end_gap))
    return {at(wall, local[2], s), m_side * see.gap, false};
  return {at(local.head<2>(), see.end * (m_inner + m_fillet), s), m_side * end_gap, false};
}

SurfaceFrame<3> RoundedPrism::frame(const SurfacePlace<3>& place) const {
  const Seen see = seen(m_frame.local(place.y), place.hint);
  SurfaceFrame<3> frame;
  if (see.out <= 0 && see.along > 0) {
    frame.n = m_side * see.end * m_frame.base.col(2);
    frame.E.col(0) = m_frame.base.col(0);
    frame.E.col(1) = frame.n.cross(frame.E.col(0));
    frame.B.setZero();
    return frame;
  }
  const SurfaceFrame<2> section = m_section.frame(see.place);
  const bool edge = see.along > 0;
  const double distance = edge ? std::hypot(see.out, see.along) : 1;
  const double across = edge ? see.out / distance : 1, along = edge ? see.along / distance : 0;
  frame.n =
      m_side * (across * m_frame.base.leftCols<2>() * section.n + along * see.end * m_frame.base.col(2));
  frame.E.col(0) = m_frame.base.leftCols<2>() * section.E;
  frame.E.col(1) = frame.n.cross(frame.E.col(0));
  // the section's curvature about the inner prism, whose own may be a corner
  const double k = section.B(0), flat = 1 - k * m_fillet;
  const double around = std::abs(flat) <= FILLET_ROUNDING ? k : across * k / (flat + k * m_fillet * across);
  frame.B << m_side * around, 0, 0, m_side * (edge ? 1 / m_fillet : 0);
  return frame;
}

int RoundedPrism::piece(const SurfacePlace<3>& place) const {
  const Seen see = seen(m_frame.local(place.y), place.hint);
  if (see.along > 0 && see.out <= 0) return see.end > 0 ? -1 : -2;
  return 3 * m_section.piece(see.place) + (see.along <= 0 ? 0 : see.end > 0 ? 1 : 2);
}

Vector<2> RoundedPrism::center() const {
  const auto places = m_section.samples(SECTION_PLACES);
  Vector<2> sum = Vector<2>::Zero();
  for (const auto& place : places) sum += place.y;
  return sum / static_cast<double>(places.size());
}

// From the middle of one end out to the walls, along them and in to the other middle.
std::vector<SurfacePlace<3>> RoundedPrism::samples(int n) const {
  const Vector<2> middle = center();
  const double reach = m_section.length_scale(), half = m_inner + m_fillet;
  std::vector<SurfacePlace<3>> places;
  for (const auto& place : m_section.samples(n)) {
    const double way = spread(static_cast<int>(places.size())) * 2 * (reach + half) - reach - half;
    const double on_end = std::clamp((std::abs(way) - half) / reach, 0., 1.);
    const Vector<2> y = middle + std::sqrt(1 - on_end) * (place.y - middle);
    const double along = std::clamp(way, -half, half);
    places.push_back(
        foot(m_frame.global(Vector<3>(y[0], y[1], along)), Param<3>(place.hint[0], along)).place);
  }
  return places;
}

std::vector<SurfacePlace<3>> RoundedPrism::outline(int n) const {
  std::vector<SurfacePlace<3>> places;
  for (const auto& place : m_section.outline(n)) places.push_back(at(place.y, 0, place.hint[0]));
  return places;
}

// The flat part of an end.
void RoundedPrism::add_end(SurfaceMesh& mesh, const std::vector<SurfacePlace<2>>& outline, double end) const {
  std::vector<Vector<2>> rim;
  for (std::size_t i = 0; i + 1 < outline.size(); ++i)
    rim.push_back(outline[i].y - m_fillet * m_section.frame(outline[i]).n);
  const int first = static_cast<int>(mesh.points.size());
  for (const Vector<2>& y : rim) mesh.points.push_back(at(y, end * (m_inner + m_fillet), 0).y);
  for (auto triangle : polygon_triangles(rim)) {
    if (m_side * end < 0) std::swap(triangle[1], triangle[2]);
    mesh.triangles.push_back({first + triangle[0], first + triangle[1], first + triangle[2]});
  }
}

SurfaceMesh RoundedPrism::mesh(const Eigen::AlignedBox3d& window) const {
  const double sagitta = 0.5 * MESH_SAGITTA * window.sizes().maxCoeff();
  const auto allowed = [&](const Vector<2>&, const Vector<2>&) { return sagitta; };
  const auto outline = refined_outline<2>(m_section, MESH_PLACES, allowed);
  const double step = 2 * std::acos(std::max(1 - sagitta / m_fillet, 0.));
  const int count = static_cast<int>(std::ceil(std::clamp(M_PI_2 / step, 2., 360.)));
  std::vector<std::vector<SurfacePlace<3>>> rows;
  for (const auto& place : outline) {
    const Vector<2> n = m_section.frame(place).n;
    rows.emplace_back();
    for (const double end : {-1., 1.})
      for (int i = 0; i <= count; ++i) { // from the end to the wall, and from it to the other end
        const double angle = M_PI_2 * (end < 0 ? count - i : i) / count;
        rows.back().push_back(at(place.y + m_fillet * (std::cos(angle) - 1) * n,
                                 end * (m_inner + m_fillet * std::sin(angle)), place.hint[0]));
      }
  }
  SurfaceMesh mesh;
  add_rows(mesh, *this, rows);
  for (const double end : {-1., 1.}) add_end(mesh, outline, end);
  return mesh;
}

} // namespace burnish
