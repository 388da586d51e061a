// From a CAD file to the faces that a tool may consist of, with their sides.
#include "base/error.hpp"
#include "base/sentence.hpp"
#include "cad/cad_text.hpp"
#include "cad/occ/cad_shape.hpp"
#include "cad/occ/cad_surface.hpp"
#include "cad/occ/occ_guard.hpp"
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <set>

namespace burnish {

namespace {

constexpr const char* CAD_FACES = "CadSurface";

bool is_closed(const TopoDS_Shape& shell) {
  TopTools_IndexedDataMapOfShapeListOfShape faces;
  TopExp::MapShapesAndAncestors(shell, TopAbs_EDGE, TopAbs_FACE, faces);
  for (int i = 1; i <= faces.Extent(); ++i) {
    const TopoDS_Edge edge = TopoDS::Edge(faces.FindKey(i));
    const auto& around = faces(i);
    if (BRep_Tool::Degenerated(edge) || edge.Orientation() == TopAbs_INTERNAL) continue;
    if (around.Extent() < 2 && !BRep_Tool::IsClosed(edge, TopoDS::Face(around.First()))) return false;
  }
  return faces.Extent() > 0;
}

/// All faces of a file, in the order of their numbers.
struct AllFaces {
  std::vector<TopoDS_Face> faces;
  std::vector<char> sided;          ///< in a closed shell, oriented out of it
  std::vector<TopoDS_Shape> bodies; ///< solid or shell that has it, or null

  void add(const TopoDS_Shape& part, bool has_side, const TopoDS_Shape& body) {
    for (TopExp_Explorer face(part, TopAbs_FACE); face.More(); face.Next()) {
      if (known.Contains(face.Current())) continue;
      known.Add(face.Current());
      faces.push_back(TopoDS::Face(face.Current()));
      sided.push_back(has_side);
      bodies.push_back(body);
    }
  }
  void add_solid(TopoDS_Solid solid) {
    const bool has_side = is_closed(solid) && BRepLib::OrientClosedSolid(solid);
    add(solid, has_side, solid);
  }
  void add_shell(const TopoDS_Shape& shell) {
    TopoDS_Solid solid;
    BRep_Builder().MakeSolid(solid);
    BRep_Builder().Add(solid, shell);
    add_solid(solid);
  }
  TopTools_IndexedMapOfShape known;
};

// Faces of no closed shell are sewn: files have sheets whose neighbors have an edge each. What becomes closed has a side.
void sew(AllFaces& all) {
  constexpr double tolerance = 1e-6;
  BRepBuilderAPI_Sewing sewing(tolerance);
  for (std::size_t i = 0; i < all.faces.size(); ++i)
    if (!all.sided[i]) sewing.Add(all.faces[i]);
  sewing.Perform();
  TopoDS_Shape sewn = sewing.SewedShape();
  if (sewn.IsNull()) return;
  AllFaces found;
  for (TopExp_Explorer shell(sewn, TopAbs_SHELL); shell.More(); shell.Next())
    found.add_shell(shell.Current());
  for (std::size_t i = 0; i < all.faces.size(); ++i) {
    if (all.sided[i] || !sewing.IsModifiedSubShape(all.faces[i])) continue;
    const int at = found.known.FindIndex(sewing.ModifiedSubShape(all.faces[i]));
    if (at == 0) continue;
    all.faces[i] = found.faces[static_cast<std::size_t>(at - 1)];
    all.sided[i] = found.sided[static_cast<std::size_t>(at - 1)];
    all.bodies[i] = found.bodies[static_cast<std::size_t>(at - 1)];
  }
}

// Solids first, then other shells, then single faces, as gmsh counts.
AllFaces faces_of(const TopoDS_Shape& shape) {
  AllFaces all;
  for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next())
    all.add_solid(TopoDS::Solid(solid.Current()));
  for (TopExp_Explorer shell(shape, TopAbs_SHELL, TopAbs_SOLID); shell.More(); shell.Next())
    all.add_shell(shell.Current());
  all.add(shape, false, {});
  if (std::count(all.sided.begin(), all.sided.end(), 0) > 1) sew(all);
  return all;
}

std::vector<int> checked_tags(const CadSelection& selection, const AllFaces& all) {
  const int count = static_cast<int>(all.faces.size());
  const std::string quoted = "\"" + selection.file + "\"";
  if (count == 0) fail(CAD_FACES, quoted + ": no faces in it");
  std::set<int> seen;
  for (const int tag : selection.faces) {
    if (!seen.insert(tag).second) fail(CAD_FACES, "face " + std::to_string(tag) + " is given twice");
    if (tag < 1 || tag > count)
      fail(CAD_FACES, quoted + " has no face " + std::to_string(tag) + ", " +
                          (count == 1 ? "its only one is 1" : "its faces are 1 to " + std::to_string(count)));
  }
  if (!selection.faces.empty()) return selection.faces;
  std::vector<int> tags;
  for (int tag = 1; tag <= count; ++tag) tags.push_back(tag);
  return tags;
}

[[noreturn]] void refuse_side(const CadSelection& selection, int tag, const TopoDS_Face& face) {
  const TrimmedFace trimmed(tag, face, false);
  const Vector<3> x = selection.scale * trimmed.data().x, n = trimmed.data().n;
  fail(CAD_FACES, sentence("face ", tag, " of \"", selection.file,
                           "\" has no side of its own: it is not in a closed shell. Its normal at (",
                           place_text(x), ") is (", place_text(n),
                           "): give inside = false for a body there, true for one on the other side"));
}

TopoDS_Shape checked_shape(const CadSelection& selection) {
  const std::string& path = selection.file;
  if (!selection.numbers.empty() || file_extension(path) == ".geo")
    fail(CAD_FACES, "\"" + path + "\": faces are taken from .step, .stp and .brep files; let gmsh write one");
  check_cad_text(path, {});
  return read_topology(path);
}

} // namespace

std::vector<CadFaceSource> read_faces(const CadSelection& selection) {
  const TopoDS_Shape shape = checked_shape(selection);
  const OccGuard guard;
  AllFaces all;
  const std::string thrown = guard.run([&] {
    if (!shape.IsNull()) all = faces_of(shape);
  });
  if (!thrown.empty())
    fail(CAD_FACES, "\"" + selection.file + "\" has faces that OpenCASCADE cannot use: " + thrown);
  std::vector<CadFaceSource> sources;
  for (const int tag : checked_tags(selection, all)) {
    const auto i = static_cast<std::size_t>(tag - 1);
    if (!all.sided[i] && !selection.side_given) refuse_side(selection, tag, all.faces[i]);
    sources.push_back({tag, all.faces[i], all.bodies[i], selection.inside});
  }
  return sources;
}

bool has_faces_in_space(const std::string& path) {
  constexpr double in_plane = 1e-6; // of the size, and of OpenCASCADE's unit: its boxes have a gap of 1e-7
  const std::string end = file_extension(path);
  if (end != ".step" && end != ".stp" && end != ".brep") return false;
  try {
    check_cad_text(path, {});
    const TopoDS_Shape shape = read_topology(path);
    const OccGuard guard;
    bool found = false;
    guard.run([&] {
      for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next()) {
        Bnd_Box box;
        BRepBndLib::Add(face.Current(), box, false);
        if (box.IsVoid()) continue;
        const Vector<3> low = from_occ(box.CornerMin().XYZ()), high = from_occ(box.CornerMax().XYZ());
        found = found || std::max(-low[2], high[2]) > in_plane * ((high - low).norm() + 1);
      }
    });
    return found;
  } catch (const std::invalid_argument&) { // whoever reads it tells why
    return false;
  }
}

} // namespace burnish
