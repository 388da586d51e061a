// Profiles of the plane that are turned about an axis or swept along it, as scripts name them.
#include "base/error.hpp"
#include "base/sentence.hpp"
#include "geometry/extruded.hpp"
#include "geometry/revolved.hpp"
#include "geometry/rounded_prism.hpp"
#include "shapes/shapes.hpp"
#include "shapes/surface_kinds.hpp"

namespace burnish {
namespace {

using Made = std::shared_ptr<const Surface<3>>;

Arguments without(Arguments given, const std::vector<Parameter>& parameters) {
  for (const Parameter& parameter : parameters) {
    given.numbers.erase(parameter.name);
    given.lists.erase(parameter.name);
    given.flags.erase(parameter.name);
  }
  return given;
}

std::vector<Parameter> revolve_parameters() {
  return {{"revolve", ArgumentKind::FLAG,
           "true: a profile turned about an axis; its x is the distance from the axis"},
          axis_parameter()};
}

std::vector<Parameter> extrude_parameters() {
  return {{"extrude", ArgumentKind::FLAG, "true: a profile of the tool's x, y plane swept along an axis"},
          {"length", ArgumentKind::NUMBER,
           "from end to end, half on each side of the origin; endless unless given [length]"},
          fillet_parameter(),
          axis_parameter()};
}

void require_true(const Arguments& given, const char* word) {
  if (!given.flag(word)) fail(word, std::string(word) + " = false, expected true, or leave it out");
}

Made revolved(const Arguments& given) {
  require_true(given, "revolve");
  const auto surface =
      std::make_shared<Revolved>(make_shape(without(given, revolve_parameters())), axis_of("revolve", given));
  constexpr double on_axis = 1e-6;
  const AxisFrame axis = axis_of("revolve", given);
  for (const auto& end : surface->ends()) {
    const Vector<3> place = axis.local(end.y);
    if (place.head<2>().norm() > on_axis * surface->length_scale()) continue;
    fail("revolve",
         sentence("the profile meets the axis at y = ", place[2],
                  " and not at a right angle: a tip without normal; let it end there in a line across the "
                  "axis, with a fillet before it"));
  }
  return surface;
}

Made extruded(const Arguments& given) {
  require_true(given, "extrude");
  Arguments flat = without(given, extrude_parameters());
  AxisFrame axis = axis_of("extrude", given);
  if (!given.has("length")) {
    if (given.has("fillet"))
      fail("extrude", "fillet= rounds the edges of the ends, and without length= there are none");
    return std::make_shared<Extruded>(make_shape(flat), axis);
  }
  const double length = given.number("length", 0);
  require(std::isfinite(length) && length > 0, "extrude", "length", length, "a finite number > 0");
  const ProfileSurface section(make_shape(flat));
  if (!section.closed()) {
    if (given.has("fillet"))
      fail("extrude", "fillet= rounds the edges of a closed profile, and this one is open");
    axis.point = -length / 2 * axis.base.col(2);
    return std::make_shared<Extruded>(make_shape(flat), axis, length);
  }
  flat.flags.erase("inside"); // of the whole
  const auto outside = make_shape(flat);
  const auto place = ProfileSurface(outside).outline(3).front().y;
  return with_fillet("extrude", given, sentence("x = ", place[0], ", y = ", place[1], ", z = ", length / 2),
                     length / 2, [&](double fillet) {
                       return std::make_shared<RoundedPrism>(outside, axis, length, fillet,
                                                             given.flag("inside"));
                     });
}

} // namespace

SurfaceKind revolve_shape() { return {"revolve=true", revolve_parameters(), revolved, "", true}; }

SurfaceKind extrude_shape() { return {"extrude=true", extrude_parameters(), extruded, "", true}; }

} // namespace burnish
