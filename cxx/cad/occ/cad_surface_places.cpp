// Places of a CAD surface for checks and pictures, and its triangles.
#include "base/child_process.hpp"
#include "base/error.hpp"
#include "base/temporary.hpp"
#include "cad/occ/cad_surface.hpp"
#include "cad/occ/occ_guard.hpp"
#include "geometry/spread.hpp"
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cstring>
#include <unistd.h>

namespace burnish {

namespace {

// A copy, which the triangles stay with.
TopoDS_Shape triangulated(const TopoDS_Face& face, double sagitta) {
  constexpr double angle = 0.5; // rad between neighbors at most
  const TopoDS_Shape copy = BRepBuilderAPI_Copy(face, false, false).Shape();
  BRepMesh_IncrementalMesh(copy, sagitta, false, angle, false);
  return copy;
}

void add_triangles(SurfaceMesh& mesh, const TopoDS_Face& face, bool turned, double scale) {
  TopLoc_Location location;
  const auto triangles = BRep_Tool::Triangulation(face, location);
  if (triangles.IsNull()) return;
  const int first = static_cast<int>(mesh.points.size()) - 1; // OpenCASCADE counts from 1
  for (int i = 1; i <= triangles->NbNodes(); ++i)
    mesh.points.push_back(scale * from_occ(triangles->Node(i).Transformed(location.Transformation()).XYZ()));
  const bool backwards = (face.Orientation() == TopAbs_REVERSED) != turned;
  for (int i = 1; i <= triangles->NbTriangles(); ++i) {
    int a = 0, b = 0, c = 0;
    triangles->Triangle(i).Get(a, b, c);
    if (backwards) std::swap(b, c);
    mesh.triangles.push_back({first + a, first + b, first + c});
  }
}

// The bytes of a mesh behind the number of its points.
std::string packed(const SurfaceMesh& mesh) {
  const std::size_t count = mesh.points.size();
  std::string bytes(reinterpret_cast<const char*>(&count), sizeof count);
  for (const Vector<3>& point : mesh.points)
    bytes.append(reinterpret_cast<const char*>(point.data()), 3 * sizeof(double));
  for (const auto& triangle : mesh.triangles)
    bytes.append(reinterpret_cast<const char*>(triangle.data()), sizeof triangle);
  return bytes;
}

SurfaceMesh unpacked(const std::string& bytes) {
  SurfaceMesh mesh;
  std::size_t count = 0, at = sizeof count;
  std::memcpy(&count, bytes.data(), sizeof count);
  mesh.points.resize(count);
  for (Vector<3>& point : mesh.points) {
    std::memcpy(point.data(), bytes.data() + at, 3 * sizeof(double));
    at += 3 * sizeof(double);
  }
  mesh.triangles.resize((bytes.size() - at) / sizeof(mesh.triangles[0]));
  for (auto& triangle : mesh.triangles) {
    std::memcpy(triangle.data(), bytes.data() + at, sizeof triangle);
    at += sizeof triangle;
  }
  return mesh;
}

} // namespace

std::vector<SurfacePlace<3>> CadSurface::ends() const {
  std::vector<SurfacePlace<3>> places;
  for (const FaceEdge& edge : m_edges)
    for (int i = 0; edge.kind != EdgeKind::JOINT && i < RIM_PLACES; ++i)
      places.push_back(edge_place(edge, edge.curve.parameter(i / (RIM_PLACES - 1.))));
  for (std::size_t f = 0; f < m_faces.size(); ++f)
    if (const Vector<3>* tip = m_faces[f].support().tip())
      places.push_back(place_of(f, m_faces[f].support().at(gp_Pnt2d(), *tip)));
  return places;
}

double CadSurface::distance_to_end(const SurfacePlace<3>& place) const {
  const Vector<3> y = place.y / m_scale;
  double distance = std::numeric_limits<double>::infinity();
  m_rim_tree.near(y, distance, [&](int i) {
    const EdgePart& at = m_rims[static_cast<std::size_t>(i)];
    distance =
        std::min(distance, m_edges[static_cast<std::size_t>(at.edge)].curve.nearest(at.part, y).distance);
  });
  for (const TrimmedFace& face : m_faces)
    if (face.support().tip()) distance = std::min(distance, (*face.support().tip() - y).norm());
  return m_scale * distance;
}

// On each face by the share of its box.
std::vector<SurfacePlace<3>> CadSurface::samples(int n) const {
  constexpr int tries = 200; // for a face that holds little of its parameters' box
  std::vector<double> share{0};
  for (const TrimmedFace& face : m_faces) share.push_back(share.back() + std::pow(face.data().size, 2));
  std::vector<int> next(m_faces.size(), 0);
  std::vector<SurfacePlace<3>> places;
  for (int i = 0; i < n; ++i) {
    const double at = spread(i) * share.back();
    const auto f = static_cast<std::size_t>(std::upper_bound(share.begin() + 1, share.end() - 1, at) -
                                            share.begin() - 1);
    SupportFoot place;
    bool found = false;
    for (int k = 0; k < tries && !found; ++k) found = m_faces[f].sample(next[f]++, place);
    places.push_back(found ? place_of(f, place)
                           : foot(m_scale * m_faces[f].data().x, Param<3>(static_cast<double>(f), 0)).place);
  }
  return places;
}

std::vector<SurfacePlace<3>> CadSurface::outline(int n) const {
  double length = 0;
  for (const FaceEdge& edge : m_edges) length += edge.curve.length();
  std::vector<SurfacePlace<3>> places;
  for (const FaceEdge& edge : m_edges) {
    const int count = std::max(2, static_cast<int>(std::ceil(n * edge.curve.length() / length)));
    for (int i = 0; i < count; ++i)
      places.push_back(edge_place(edge, edge.curve.parameter(i / (count - 1.))));
  }
  return places;
}

// In a process of its own: OpenCASCADE may be busy for ever with a face whose borders cross.
SurfaceMesh CadSurface::mesh(const Eigen::AlignedBox3d& window) const {
  constexpr double margin = 0.8; // of what is allowed: OpenCASCADE's own estimate
  constexpr unsigned seconds = 60;
  const double sagitta = margin * MESH_SAGITTA * window.sizes().maxCoeff() / m_scale;
  const TemporaryFolder folder;
  const ChildEnd end = run_in_child(
      [&] {
        alarm(seconds);
        const OccGuard guard;
        SurfaceMesh mesh;
        const std::string thrown = guard.run([&] {
          for (const TrimmedFace& face : m_faces)
            add_triangles(mesh, TopoDS::Face(triangulated(face.data().face, sagitta)), face.data().turned,
                          m_scale);
        });
        return thrown.empty() ? packed(mesh) : "";
      },
      folder.path() + "/log");
  if (!end.returned || end.result.empty())
    fail("CadSurface::mesh", "OpenCASCADE cannot divide the faces into triangles");
  return unpacked(end.result);
}

} // namespace burnish
