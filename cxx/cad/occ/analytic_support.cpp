// Planes, balls, cylinders, cones and rings of CAD files by the core's closed forms.
#include "cad/occ/closed_support.hpp"
#include "geometry/circle.hpp"
#include "geometry/extruded.hpp"
#include "geometry/plane_surface.hpp"
#include "geometry/revolved.hpp"
#include "geometry/segment.hpp"
#include "geometry/simple_surfaces.hpp"
#include <BRep_Tool.hxx>
#include <ElSLib.hxx>
#include <GeomAdaptor_Surface.hxx>

namespace burnish {

namespace {

using Support = std::unique_ptr<FaceSupport>;

AxisFrame frame_about(const gp_Ax3& position) {
  return axis_frame("CadSurface", from_occ(position.Location().XYZ()), from_occ(position.Direction().XYZ()));
}

template <class Shape> ClosedSupport::Parameters parameters_on(const Shape& shape) {
  return [shape](const Vector<3>& y, double) {
    double u = 0, v = 0;
    ElSLib::Parameters(shape, to_occ(y), u, v);
    return gp_Pnt2d(u, v);
  };
}

Support plane_support(const FaceData& data, const gp_Pln& plane) {
  const auto make = [&](bool inside) {
    return std::make_shared<PlaneSurface>(data.x, inside ? Vector<3>(-data.n) : data.n, data.size);
  };
  return std::make_unique<ClosedSupport>(data, make, parameters_on(plane));
}

Support cylinder_support(const FaceData& data, const gp_Cylinder& cylinder) {
  const AxisFrame axis = frame_about(cylinder.Position());
  const auto make = [&](bool inside) {
    return std::make_shared<Extruded>(std::make_shared<Circle>(cylinder.Radius(), inside), axis);
  };
  return std::make_unique<ClosedSupport>(data, make, parameters_on(cylinder));
}

Support sphere_support(const FaceData& data, const gp_Sphere& ball) {
  const auto make = [&](bool inside) { return sphere(ball.Radius(), frame_about(ball.Position()), inside); };
  return std::make_unique<ClosedSupport>(data, make, parameters_on(ball));
}

// Null for one that passes through its own axis.
Support torus_support(const FaceData& data, const gp_Torus& ring) {
  if (!(ring.MinorRadius() < ring.MajorRadius())) return nullptr;
  const auto make = [&](bool inside) {
    return torus(ring.MajorRadius(), ring.MinorRadius(), frame_about(ring.Position()), inside);
  };
  return std::make_unique<ClosedSupport>(data, make, parameters_on(ring));
}

// A line from a little before the face to a little behind it, or to the tip. Null if the face lies on both sides of it.
Support cone_support(const FaceData& data, const gp_Cone& cone) {
  constexpr double more = 0.1;
  const double sine = std::sin(cone.SemiAngle()), cosine = std::cos(cone.SemiAngle());
  const double margin = more * (data.v1 - data.v0), at_tip = -cone.RefRadius() / sine;
  const double close = 1e-9 * data.size;
  const auto radius = [&](double v) { return cone.RefRadius() + v * sine; };
  if (radius(data.v0) < -close || radius(data.v1) < -close) return nullptr;
  double begin = data.v0 - margin, end = data.v1 + margin;
  if (sine > 0) begin = std::max(begin, at_tip);
  if (sine < 0) end = std::min(end, at_tip);
  Vector<2> first(std::max(radius(begin), 0.), begin * cosine), last(std::max(radius(end), 0.), end * cosine);
  if (begin == at_tip) first[0] = 0;
  if (end == at_tip) last[0] = 0;
  const AxisFrame axis = frame_about(cone.Position());
  const auto make = [&](bool inside) {
    return std::make_shared<Revolved>(
        inside ? std::make_shared<Segment>(first, last) : std::make_shared<Segment>(last, first), axis);
  };
  std::optional<Vector<3>> tip;
  if (std::min(radius(data.v0), radius(data.v1)) <= close)
    tip = axis.global(Vector<3>(0, 0, at_tip * cosine));
  return std::make_unique<ClosedSupport>(data, make, parameters_on(cone), tip);
}

} // namespace

std::unique_ptr<FaceSupport> analytic_support(const FaceData& data) {
  const GeomAdaptor_Surface surface(BRep_Tool::Surface(data.face));
  switch (surface.GetType()) {
  case GeomAbs_Plane:
    return plane_support(data, surface.Plane());
  case GeomAbs_Cylinder:
    return cylinder_support(data, surface.Cylinder());
  case GeomAbs_Sphere:
    return sphere_support(data, surface.Sphere());
  case GeomAbs_Torus:
    return torus_support(data, surface.Torus());
  case GeomAbs_Cone:
    return cone_support(data, surface.Cone());
  default:
    return nullptr;
  }
}

} // namespace burnish
