// Curves of a plane that are turned about an axis in it or swept normal to it, in CAD files: closest points in that plane.
#include "cad/occ/cad_curve.hpp"
#include "cad/occ/cad_edge.hpp"
#include "cad/occ/closed_support.hpp"
#include "geometry/extruded.hpp"
#include "geometry/revolved.hpp"
#include <BRep_Tool.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <gp_Ax3.hxx>
#include <gp_Trsf.hxx>

namespace burnish {

namespace {

constexpr double IN_PLANE = 1e-9; // of the size of the face
constexpr int PLANE_SAMPLES = 32;

/// A curve with its range, as the sweep has it.
struct Section {
  Handle(Geom_Curve) curve;
  double begin, end;
  Vector<3> at(int i) const {
    return from_occ(curve->Value(begin + (end - begin) * i / PLANE_SAMPLES).XYZ());
  }
};

Section section_of(Handle(Geom_Curve) curve, double begin, double end) {
  while (const auto* trimmed = dynamic_cast<const Geom_TrimmedCurve*>(curve.get()))
    curve = trimmed->BasisCurve();
  return {curve, begin, end};
}

/// The piece in the plane of the first two directions of the frame; of a revolution e1 and the axis are these.
CadPiece piece_in(const Section& section, const Vector<3>& origin, const Vector<3>& e1, const Vector<3>& e2,
                  const std::string& name) {
  const auto direction = [](const Vector<3>& e) { return gp_Dir(e[0], e[1], e[2]); };
  gp_Trsf to_plane;
  to_plane.SetTransformation(gp_Ax3(to_occ(origin), direction(e1.cross(e2)), direction(e1)));
  CadEdge edge;
  edge.curve = Handle(Geom_Curve)::DownCast(section.curve->Transformed(to_plane));
  edge.begin = section.begin;
  edge.end = section.end;
  return {1, ExactCurve(edge, name), 1};
}

double wrapped_parameter(const CadPiece& piece, double s) {
  if (s < 0 || s > piece.length()) s -= piece.length() * std::floor(s / piece.length());
  return piece.parameter(s);
}

std::unique_ptr<FaceSupport> turned_support(const FaceData& data, const Geom_SurfaceOfRevolution& surface) {
  const Section section = section_of(surface.BasisCurve(), data.v0, data.v1);
  AxisFrame axis =
      axis_frame("CadSurface", from_occ(surface.Location().XYZ()), from_occ(surface.Direction().XYZ()));
  Vector<3> furthest = Vector<3>::Zero();
  for (int i = 0; i <= PLANE_SAMPLES; ++i) {
    const Vector<3> local = axis.local(section.at(i));
    if (local.head<2>().norm() > furthest.head<2>().norm()) furthest = local;
  }
  if (!(furthest.head<2>().norm() > IN_PLANE * data.size)) return nullptr;
  const Vector<3> radial = axis.base * Vector<3>(furthest[0], furthest[1], 0);
  axis = axis_frame("CadSurface", axis.point, axis.base.col(2), radial);
  for (int i = 0; i <= PLANE_SAMPLES; ++i) {
    const Vector<3> local = axis.local(section.at(i));
    if (std::abs(local[1]) > IN_PLANE * data.size || local[0] < -IN_PLANE * data.size) return nullptr;
  }
  const CadPiece piece = piece_in(section, axis.point, axis.base.col(0), axis.base.col(2), data.name);
  const auto make = [&](bool inside) {
    return std::make_shared<Revolved>(std::make_shared<CadCurve>(std::vector<CadPiece>{piece}, inside), axis);
  };
  const auto uv = [axis, piece](const Vector<3>& y, double s) {
    const Vector<3> local = axis.local(y);
    return gp_Pnt2d(std::atan2(local[1], local[0]), wrapped_parameter(piece, s));
  };
  return std::make_unique<ClosedSupport>(data, make, uv);
}

std::unique_ptr<FaceSupport> extruded_support(const FaceData& data,
                                              const Geom_SurfaceOfLinearExtrusion& surface) {
  const Section section = section_of(surface.BasisCurve(), data.u0, data.u1);
  const AxisFrame frame = axis_frame("CadSurface", section.at(0), from_occ(surface.Direction().XYZ()));
  for (int i = 0; i <= PLANE_SAMPLES; ++i)
    if (std::abs(frame.local(section.at(i))[2]) > IN_PLANE * data.size) return nullptr;
  const CadPiece piece = piece_in(section, frame.point, frame.base.col(0), frame.base.col(1), data.name);
  const auto make = [&](bool inside) {
    return std::make_shared<Extruded>(std::make_shared<CadCurve>(std::vector<CadPiece>{piece}, inside),
                                      frame);
  };
  const auto uv = [frame, piece](const Vector<3>& y, double s) {
    return gp_Pnt2d(wrapped_parameter(piece, s), frame.local(y)[2]);
  };
  return std::make_unique<ClosedSupport>(data, make, uv);
}

} // namespace

std::unique_ptr<FaceSupport> swept_support(const FaceData& data) {
  Handle(Geom_Surface) surface = BRep_Tool::Surface(data.face);
  while (const auto* trimmed = dynamic_cast<const Geom_RectangularTrimmedSurface*>(surface.get()))
    surface = trimmed->BasisSurface();
  try {
    if (const auto* turned = dynamic_cast<const Geom_SurfaceOfRevolution*>(surface.get()))
      return turned_support(data, *turned);
    if (const auto* swept = dynamic_cast<const Geom_SurfaceOfLinearExtrusion*>(surface.get()))
      return extruded_support(data, *swept);
  } catch (
      const std::invalid_argument&) { // a section with a corner, that crosses itself: as any other surface
  }
  return nullptr;
}

} // namespace burnish
