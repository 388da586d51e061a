#include "cad/occ/geo_model.hpp"
#include "base/error.hpp"
#include "base/temporary.hpp"
#include "cad/cad_text.hpp"
#include "cad/companion_gmsh/burnish_gmsh.h"
#include "cad/occ/cad_shape.hpp"
#include "cad/occ/geo_drawing.hpp"
#include <filesystem>
#include <fstream>

namespace burnish {

namespace {

constexpr const char* GEO_MODEL = "CadFile";
constexpr double SAME = 1e-6; // of the size of a curve: gmsh has the ends of ellipses to 1e-8 of it

/// What gmsh tells of a curve.
struct Told {
  bool exact = false; ///< of OpenCASCADE
  std::array<gp_Pnt, BURNISH_GMSH_PLACES> x;
  std::string kind;
};

// Also "nan" and "inf", which streams do not read.
double next_number(std::istream& stream) {
  std::string word;
  stream >> word;
  return std::strtod(word.c_str(), nullptr);
}

std::map<int, Told> read_entities(const std::string& path, CadModel& model) {
  std::map<int, Told> curves;
  std::ifstream stream(path);
  for (int dimension = 0, tag = 0; stream >> dimension >> tag;) {
    if (dimension != 1) {
      model.others.at(static_cast<std::size_t>(dimension)).insert(tag);
      continue;
    }
    Told& told = curves[tag];
    stream >> told.exact;
    for (gp_Pnt& x : told.x)
      for (int i = 1; i <= 3; ++i) x.SetCoord(i, next_number(stream));
    std::getline(stream >> std::ws, told.kind);
  }
  return curves;
}

bool agrees(const CadEdge& edge, const Told& told) {
  double size = 0, largest = 0, apart = 0;
  for (std::size_t i = 0; i < told.x.size(); ++i) {
    const gp_Pnt x = edge.curve->Value(edge.begin + burnish_gmsh_place[i] * (edge.end - edge.begin));
    size = std::max(size, told.x[i].Distance(told.x[0]));
    largest = std::max(largest, told.x[i].XYZ().Modulus());
    apart = std::max(apart, x.Distance(told.x[i]));
  }
  return apart <= SAME * size + 1e-12 * largest;
}

// Curves of OpenCASCADE, in the order of their tags.
void take_exact(CadModel& model, const std::map<int, Told>& curves, const std::string& path) {
  if (!std::filesystem::exists(path)) return;
  const auto edges = read_edges(path);
  std::size_t next = 0;
  for (const auto& [tag, told] : curves)
    if (told.exact && next < edges.size()) model.edges[tag] = edges[next++];
}

void take_drawn(CadModel& model, const std::map<int, Told>& curves, const std::string& path) {
  std::map<int, gp_Pnt> middles;
  for (const auto& [tag, told] : curves)
    if (!told.exact) middles[tag] = told.x[BURNISH_GMSH_PLACES / 2];
  if (!middles.empty()) model.edges.merge(drawn_curves(file_content(path), middles));
}

} // namespace

CadModel read_geo(const std::string& path, const GeoNumbers& numbers, double seconds) {
  const TemporaryFolder folder;
  std::string said = trimmed(gmsh_curves(path, numbers, folder.path(), seconds));
  if (said == "OpenCASCADE exception")
    said += "; are points of a curve closer than 1e-7, which it takes for one? Draw it larger";
  if (!said.empty()) fail(GEO_MODEL, "\"" + path + "\": " + said);
  CadModel model;
  const auto curves = read_entities(folder.path() + "/entities", model);
  take_exact(model, curves, folder.path() + "/opencascade.brep");
  take_drawn(model, curves, folder.path() + "/builtin.geo_unrolled");
  for (const auto& [tag, told] : curves) {
    CadEdge& edge = model.edges[tag];
    if (!edge.curve.IsNull() && agrees(edge, told)) continue;
    edge = {told.kind, nullptr, 0, 0,
            "is none that can be evaluated exactly; draw it with another kind of curve, or use "
            "SetFactory(\"OpenCASCADE\") in the .geo file"};
  }
  return model;
}

} // namespace burnish
