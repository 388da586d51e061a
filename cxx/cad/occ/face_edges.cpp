#include "cad/occ/face_edges.hpp"
#include "base/error.hpp"
#include "base/sentence.hpp"
#include "cad/occ/cad_edge.hpp"
#include <BRepLib.hxx>
#include <BRep_Tool.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

namespace burnish {

namespace {

constexpr double SMOOTH_EDGE = 1e-3;    // rad between normals
constexpr double SAME_CURVATURE = 1e-6; // of the larger one, or of 1/size
constexpr double EDGE_ROUNDING = 1e-9;  // of the size: beside OpenCASCADE's tolerance of an edge
constexpr int EDGE_PLACES = 9;          // at which an edge is looked at

SpaceCurve curve_of(const TopoDS_Edge& edge, const std::string& name) {
  CadEdge found;
  if (BRep_Tool::Curve(edge, found.begin, found.end).IsNull()) BRepLib::BuildCurve3d(edge);
  found.curve = BRep_Tool::Curve(edge, found.begin, found.end);
  while (const auto* trimmed = dynamic_cast<const Geom_TrimmedCurve*>(found.curve.get()))
    found.curve = trimmed->BasisCurve();
  found.missing = "has no curve in space";
  return SpaceCurve(ExactCurve(found, name));
}

std::string names_of_faces(const std::vector<TrimmedFace>& faces, const std::vector<int>& which) {
  std::string text;
  for (std::size_t i = 0; i < which.size(); ++i)
    text += (i == 0                 ? ""
             : i + 1 < which.size() ? ", "
                                    : " and ") +
            std::to_string(faces[static_cast<std::size_t>(which[i])].tag());
  return text;
}

/// Both sides of an edge at one place.
struct EdgeSides {
  Vector<3> n[2];
  Tensor<3> bend[2]; ///< curvature in space
  Vector<3> into;    ///< direction along the first face away from the edge
};

EdgeSides sides_at(const std::vector<TrimmedFace>& faces, const FaceEdge& edge, double u) {
  EdgeSides sides;
  const CurveValue at = edge.curve.at(u);
  for (std::size_t k = 0; k < 2; ++k) {
    const TrimmedFace& face = faces[static_cast<std::size_t>(edge.faces[k])];
    const SupportFoot place = face.support().at(face.on_edge(edge.seen[k], u), at.x);
    const SurfaceFrame<3> frame = face.support().frame(place.y, place.hint);
    sides.n[k] = frame.n;
    sides.bend[k] = frame.E * frame.B * frame.E.transpose();
  }
  // a face lies on the left of its edges, seen against its normal in the file
  const bool turned = faces[static_cast<std::size_t>(edge.faces[0])].data().turned;
  const bool backwards = edge.seen[0].Orientation() == TopAbs_REVERSED;
  sides.into = (turned != backwards ? -1 : 1) * sides.n[0].cross(at.first.normalized());
  return sides;
}

void judge(const std::vector<TrimmedFace>& faces, FaceEdge& edge, double size) {
  double towards = 0;
  edge.smooth = true;
  for (int i = 0; i < EDGE_PLACES; ++i) {
    const double f = (i + 0.5) / EDGE_PLACES,
                 u = edge.curve.begin() + f * (edge.curve.end() - edge.curve.begin());
    const EdgeSides sides = sides_at(faces, edge, u);
    const double angle = std::atan2(sides.n[0].cross(sides.n[1]).norm(), sides.n[0].dot(sides.n[1]));
    const double bend = std::max({sides.bend[0].norm(), sides.bend[1].norm(), 1 / size});
    if (!((sides.bend[0] - sides.bend[1]).norm() <= SAME_CURVATURE * bend)) edge.smooth = false;
    if (!(angle > edge.angle)) continue;
    edge.angle = angle;
    edge.sharpest = edge.curve.at(u).x;
    towards = sides.n[1].dot(sides.into);
  }
  edge.kind = edge.angle <= SMOOTH_EDGE ? EdgeKind::JOINT
              : towards > 0             ? EdgeKind::CONCAVE
                                        : EdgeKind::CONVEX;
}

} // namespace

std::string space_place_text(const Vector<3>& x, double scale, double size) {
  const Vector<3> clean = (x.array().abs() < 1e-9 * size).select(0., scale * x.array()).matrix();
  return sentence("(", clean[0], ", ", clean[1], ", ", clean[2], ")");
}

std::vector<FaceEdge> face_edges(const std::vector<TrimmedFace>& faces, double scale) {
  TopTools_IndexedMapOfShape known;
  std::vector<FaceEdge> edges;
  Eigen::AlignedBox3d all;
  for (const TrimmedFace& face : faces) all.extend(face.box());
  const double size = all.diagonal().norm();
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (TopExp_Explorer part(faces[f].data().face, TopAbs_EDGE); part.More(); part.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(part.Current());
      if (BRep_Tool::Degenerated(edge) || edge.Orientation() == TopAbs_INTERNAL ||
          edge.Orientation() == TopAbs_EXTERNAL)
        continue;
      const auto at = static_cast<std::size_t>(known.Add(edge)) - 1;
      if (at == edges.size()) edges.push_back({curve_of(edge, "an edge of " + faces[f].data().name), {}, {}});
      edges[at].faces.push_back(static_cast<int>(f));
      edges[at].seen.push_back(edge);
      edges[at].slack = 2 * BRep_Tool::Tolerance(edge) + EDGE_ROUNDING * size;
    }
  for (FaceEdge& edge : edges) {
    if (edge.faces.size() > 2)
      fail("CadSurface", "faces " + names_of_faces(faces, edge.faces) + " meet at one edge, at " +
                             space_place_text(edge.curve.at(edge.curve.begin()).x, scale, size) +
                             "; name the faces of one surface (faces = [...])");
    if (edge.faces.size() == 2) judge(faces, edge, size);
  }
  return edges;
}

} // namespace burnish
