// CAD curves and faces as scripts name them.
#include "base/error.hpp"
#include "cad/cad_library.hpp"
#include <cmath>

namespace burnish {

namespace {

// @param name "curves", "faces"
std::vector<int> tags_of(const Arguments& given, const char* name) {
  std::vector<int> tags;
  for (const double tag : given.list(name)) {
    const std::string what = std::string("tag in ") + name;
    require(tag == std::round(tag) && std::abs(tag) < 1e9, "cad", what.c_str(), tag, "an integer");
    tags.push_back(static_cast<int>(tag));
  }
  return tags;
}

CadSelection selection_of(const Arguments& given) {
  CadSelection selection;
  selection.file = given.text("cad");
  selection.scale = given.number("scale", selection.scale);
  selection.inside = given.flag("inside");
  selection.side_given = given.has("inside");
  return selection;
}

Parameter scale_parameter() {
  return {"scale", ArgumentKind::NUMBER,
          "the script's unit of length per unit of the file (STEP: per mm); 1 unless given"};
}

} // namespace

ShapeKind cad_curve_shape() {
  return {"cad=\"file\"",
          {{"cad", ArgumentKind::TEXT,
            "curves of a .geo, .step, .stp or .brep file; closed: body outside, open: on the left"},
           {"curves", ArgumentKind::NUMBERS, "tags of the curves, as gmsh numbers them; all unless given"},
           scale_parameter(),
           {"geo", ArgumentKind::TEXT, "\"R=2; H=8\", numbers for the DefineConstants of a .geo file"},
           {"inside", ArgumentKind::FLAG, "true: body on the other side"}},
          [](const Arguments& given) {
            if (given.has("curves") && given.list("curves").empty())
              fail("cad", "curves is an empty array: name curves, or leave it out to take all");
            CadSelection selection = selection_of(given);
            selection.curves = tags_of(given, "curves");
            selection.numbers = given.text("geo");
            return open_cad_curve(selection);
          }};
}

SurfaceKind cad_face_shape() {
  return {"faces=[1,2] with cad=\"file\"",
          {{"faces", ArgumentKind::NUMBERS,
            "numbers of the faces of a .step, .stp or .brep file that make the tool; all unless given"},
           {"cad", ArgumentKind::TEXT,
            "curves of a .geo, .step, .stp or .brep file; closed: body outside, open: on the left"},
           scale_parameter(),
           {"inside", ArgumentKind::FLAG, "true: body on the other side"}},
          [](const Arguments& given) {
            if (!given.has("cad")) fail("cad", "faces= names faces of a CAD file: give cad=\"file\" as well");
            CadSelection selection = selection_of(given);
            selection.faces = tags_of(given, "faces");
            return open_cad_surface(selection);
          }};
}

bool has_cad_faces(const std::string& file) { return open_cad_has_faces(file); }

} // namespace burnish
