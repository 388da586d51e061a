#include "cad/occ/cad_shape.hpp"
#include "base/child_process.hpp"
#include "base/error.hpp"
#include "base/memory_limit.hpp"
#include "base/temporary.hpp"
#include "cad/cad_text.hpp"
#include "cad/occ/occ_guard.hpp"
#include <BRepLib.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <BinTools.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Interface_Check.hxx>
#include <Interface_CheckIterator.hxx>
#include <Interface_InterfaceModel.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Iterator.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <unistd.h>

namespace burnish {

namespace {

constexpr const char* CAD_SHAPE = "CadFile";
constexpr const char* DAMAGED = "the text is damaged or cut short";
// Memory that reading may take [bytes]; a STEP file of 7 MB takes 36 MB.
constexpr double MEMORY = 5e8, MEMORY_PER_BYTE = 200;
constexpr unsigned SECONDS = 60; // that reading a file may take

// The first failure of a list of checks, with the entity that it is about.
std::string first_fail(Interface_CheckIterator checks, const Handle(Interface_InterfaceModel) & model) {
  for (checks.Start(); checks.More(); checks.Next()) {
    const Handle(Interface_Check)& check = checks.Value();
    if (!check->HasFailed()) continue;
    std::string about;
    Handle(Standard_Transient) entity = check->Entity();
    if (entity.IsNull() && checks.Number() > 0) entity = model->Value(checks.Number());
    if (!entity.IsNull() && model->Contains(entity))
      about = std::string("entity ") + model->StringLabel(entity)->ToCString() + ": ";
    return about + check->CFail(1);
  }
  return "";
}

// A file may be read to its end in spite of values that are no numbers and references to nothing.
std::string read_step(const std::string& path, TopoDS_Shape& shape) {
  STEPControl_Reader reader;
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone) return DAMAGED;
  const Handle(Interface_InterfaceModel) model = reader.WS()->Model();
  std::string said = first_fail(reader.WS()->ModelCheckList(), model);
  if (!said.empty()) return said;
  reader.TransferRoots();
  said = first_fail(reader.WS()->TransferReader()->TransientProcess()->CheckList(false), model);
  shape = reader.OneShape();
  return said;
}

// Without exceptions the reader waits for ever at the end of a file that is cut short.
std::string read_brep(const std::string& path, TopoDS_Shape& shape) {
  std::ifstream stream(path);
  stream.exceptions(std::ios::failbit | std::ios::badbit);
  try {
    BRepTools::Read(shape, stream, BRep_Builder());
  } catch (const std::ios::failure&) {
    return DAMAGED;
  }
  return "";
}

// What reading a file came to: words of what is wrong, what OpenCASCADE printed, and the shape.
struct Reading {
  std::string said, printed;
  TopoDS_Shape shape;
};

Reading read_here(const std::string& path) {
  Reading reading;
  const OccGuard guard;
  const MemoryLimit limit(MEMORY + MEMORY_PER_BYTE * static_cast<double>(std::filesystem::file_size(path)));
  const bool brep = file_extension(path) == ".brep";
  const std::string thrown = guard.run(
      [&] { reading.said = brep ? read_brep(path, reading.shape) : read_step(path, reading.shape); });
  reading.printed = guard.printed();
  if (!thrown.empty()) reading.said = std::string(DAMAGED) + " (" + thrown + ")";
  return reading;
}

// In a process of its own: a damaged STEP file leaves OpenCASCADE's reader in a state in which it may be busy for ever with
// the next one; with a parameter of 1e300 in a BREP file it is itself.
Reading read_apart(const std::string& path) {
  const TemporaryFolder folder;
  const ChildEnd end = run_in_child(
      [&] {
        alarm(SECONDS);
        const Reading reading = read_here(path);
        std::ostringstream text;
        text << reading.said.size() << ' ' << reading.printed.size() << ' ' << reading.said
             << reading.printed;
        if (reading.said.empty()) BinTools::Write(reading.shape, text);
        return text.str();
      },
      folder.path() + "/log");
  Reading reading;
  if (!end.returned) {
    reading.said =
        end.signal == SIGALRM ? "reading it takes more than " + std::to_string(SECONDS) + " s" : DAMAGED;
    return reading;
  }
  std::istringstream text(end.result);
  std::size_t said = 0, printed = 0;
  text >> said >> printed;
  text.get();
  reading.said.resize(said);
  reading.printed.resize(printed);
  text.read(reading.said.data(), static_cast<std::streamsize>(said));
  text.read(reading.printed.data(), static_cast<std::streamsize>(printed));
  if (!reading.said.empty()) return reading;
  const OccGuard guard;
  const std::string thrown = guard.run([&] { BinTools::Read(reading.shape, text); });
  if (!thrown.empty()) reading.said = std::string(DAMAGED) + " (" + thrown + ")";
  return reading;
}

TopoDS_Shape shape_in(const std::string& path) {
  const Reading reading = read_apart(path);
  if (!reading.said.empty())
    fail(CAD_SHAPE, "\"" + path + "\": " + reading.said +
                        (reading.printed.empty() ? "" : "; OpenCASCADE says: " + reading.printed));
  return reading.shape;
}

/// A file that was read.
struct ReadFile {
  std::filesystem::path path;
  std::filesystem::file_time_type written;
  std::uintmax_t size = 0;
  TopoDS_Shape shape;
};

// "Geom_BSplineCurve" is a BSpline.
std::string kind_of(const std::string& type) {
  const std::string name = type.substr(5);
  return name.substr(0, name.find("Curve"));
}

CadEdge edge_of(const TopoDS_Edge& edge, const OccGuard& guard) {
  CadEdge result;
  const bool point = BRep_Tool::Degenerated(edge);
  const std::string thrown = guard.run([&] {
    if (BRep_Tool::Curve(edge, result.begin, result.end).IsNull() && !point) BRepLib::BuildCurve3d(edge);
    result.curve = BRep_Tool::Curve(edge, result.begin, result.end);
  });
  if (!thrown.empty()) result.curve.Nullify();
  while (const auto* trimmed = dynamic_cast<const Geom_TrimmedCurve*>(result.curve.get()))
    result.curve = trimmed->BasisCurve();
  if (result.curve.IsNull()) {
    result.kind = point ? "point" : "no curve";
    result.missing = point ? "has no length: it is a single point" : "has no curve in space";
  } else {
    result.kind = kind_of(result.curve->DynamicType()->Name());
  }
  return result;
}

void fill(std::set<int>& tags, const TopTools_IndexedMapOfShape& shapes) {
  for (int tag = 1; tag <= shapes.Extent(); ++tag) tags.insert(tag);
}

} // namespace

TopoDS_Shape read_topology(const std::string& path) {
  static auto& last = *new ReadFile; // OpenCASCADE may be gone before it
  const auto absolute = std::filesystem::absolute(path);
  const auto written = std::filesystem::last_write_time(path);
  const auto size = std::filesystem::file_size(path);
  if (last.path != absolute || last.written != written || last.size != size)
    last = {absolute, written, size, shape_in(path)};
  return last.shape;
}

CadModel read_shape(const std::string& path) {
  const TopoDS_Shape shape = read_topology(path);
  CadModel model;
  if (shape.IsNull()) return model;
  const OccGuard guard;
  TopTools_IndexedMapOfShape edges, points, faces, solids;
  for (const TopAbs_ShapeEnum kind : {TopAbs_SOLID, TopAbs_FACE, TopAbs_EDGE})
    for (TopExp_Explorer part(shape, kind); part.More(); part.Next())
      TopExp::MapShapes(part.Current(), TopAbs_EDGE, edges);
  TopExp::MapShapes(shape, TopAbs_VERTEX, points);
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  TopExp::MapShapes(shape, TopAbs_SOLID, solids);
  for (int tag = 1; tag <= edges.Extent(); ++tag) model.edges[tag] = edge_of(TopoDS::Edge(edges(tag)), guard);
  fill(model.others[0], points);
  fill(model.others[2], faces);
  fill(model.others[3], solids);
  return model;
}

std::vector<CadEdge> read_edges(const std::string& path) {
  const TopoDS_Shape shape = shape_in(path);
  const OccGuard guard;
  std::vector<CadEdge> edges;
  for (TopoDS_Iterator part(shape); part.More(); part.Next())
    if (part.Value().ShapeType() == TopAbs_EDGE) edges.push_back(edge_of(TopoDS::Edge(part.Value()), guard));
  return edges;
}

} // namespace burnish
