// CAD curves as scripts name them.
#include "base/error.hpp"
#include "cad/cad_library.hpp"
#include <cmath>

namespace burnish {

namespace {

std::vector<int> tags_of(const Arguments& given) {
  std::vector<int> tags;
  if (!given.has("curves")) return tags;
  if (given.list("curves").empty())
    fail("cad", "curves is an empty array: name curves, or leave it out to take all");
  for (const double tag : given.list("curves")) {
    require(tag == std::round(tag) && std::abs(tag) < 1e9, "cad", "tag in curves", tag, "an integer");
    tags.push_back(static_cast<int>(tag));
  }
  return tags;
}

} // namespace

ShapeKind cad_curve_shape() {
  return {"cad=\"file\"",
          {{"cad", ArgumentKind::TEXT,
            "curves of a .geo, .step, .stp or .brep file; closed: body outside, open: on the left"},
           {"curves", ArgumentKind::NUMBERS, "tags of the curves, as gmsh numbers them; all unless given"},
           {"scale", ArgumentKind::NUMBER,
            "the script's unit of length per unit of the file (STEP: per mm); 1 unless given"},
           {"geo", ArgumentKind::TEXT, "\"R=2; H=8\", numbers for the DefineConstants of a .geo file"},
           {"inside", ArgumentKind::FLAG, "true: body on the other side"}},
          [](const Arguments& given) {
            CadSelection selection;
            selection.file = given.text("cad");
            selection.curves = tags_of(given);
            selection.scale = given.number("scale", selection.scale);
            selection.numbers = given.text("geo");
            selection.inside = given.flag("inside");
            return open_cad_curve(selection);
          }};
}

} // namespace burnish
