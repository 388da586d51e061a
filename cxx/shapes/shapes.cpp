#include "shapes/shapes.hpp"
#include "base/error.hpp"
#include "cad/cad_selection.hpp"
#include "geometry/arc_chain.hpp"
#include "geometry/circle.hpp"
#include "geometry/profile_surface.hpp"
#include "geometry/segment.hpp"
#include "shapes/surface_kinds.hpp"
#include <algorithm>

namespace burnish {

namespace {

template <class Shape> const std::string& word_of(const KindOf<Shape>& kind) {
  return kind.parameters[0].name;
}

template <class Shape> bool takes(const KindOf<Shape>& kind, const std::string& name) {
  const auto named = [&](const Parameter& parameter) { return parameter.name == name; };
  return std::any_of(kind.parameters.begin(), kind.parameters.end(), named);
}

bool of_a_profile(const std::string& name) {
  const auto& kinds = shape_kinds();
  return std::any_of(kinds.begin(), kinds.end(), [&](const ShapeKind& kind) { return takes(kind, name); });
}

template <class Shape> std::string examples(const std::vector<KindOf<Shape>>& kinds) {
  std::string text;
  for (std::size_t i = 0; i < kinds.size(); ++i)
    text += (i == 0 ? "" : i + 1 < kinds.size() ? ", " : " or ") + kinds[i].example;
  return text;
}

// The only kind that the arguments name.
template <class Shape>
const KindOf<Shape>& chosen_of(const std::vector<KindOf<Shape>>& kinds, const Arguments& arguments,
                               const std::string& what) {
  const KindOf<Shape>* chosen = nullptr;
  int count = 0;
  for (const KindOf<Shape>& kind : kinds) {
    if (!arguments.has(word_of(kind))) continue;
    chosen = &kind;
    ++count;
  }
  if (count != 1) fail("shape", "give exactly one " + what + ": " + examples(kinds));
  for (const Parameter& other : shape_parameters())
    if (arguments.has(other.name) && !takes(*chosen, other.name) &&
        !(chosen->takes_profile && of_a_profile(other.name)))
      fail("shape", word_of(*chosen) + "= takes no " + other.name + "=" + chosen->remark);
  return *chosen;
}

bool names_surface(const Arguments& arguments) {
  const auto named = [&](const SurfaceKind& kind) { return arguments.has(word_of(kind)); };
  return std::any_of(surface_kinds().begin(), surface_kinds().end(), named);
}

// cad= alone: what the file holds decides.
bool means_all_faces(const Arguments& arguments) {
  return arguments.has("cad") && !arguments.has("curves") && !arguments.has("geo") &&
         has_cad_faces(arguments.text("cad"));
}

template <class Shape> void add(const KindOf<Shape>& kind, std::map<std::string, Parameter>& all) {
  for (const Parameter& parameter : kind.parameters) all.emplace(parameter.name, parameter);
}

template <class Shape> std::string help_of(const std::vector<KindOf<Shape>>& kinds) {
  std::string text;
  for (const KindOf<Shape>& kind : kinds)
    for (const Parameter& parameter : kind.parameters) {
      const bool first = &parameter == &kind.parameters[0];
      std::string left = first ? kind.example : "    " + parameter.name + "=";
      left.resize(std::max<std::size_t>(left.size() + 2, 34), ' ');
      text += left + parameter.help + "\n";
    }
  return text;
}

} // namespace

const std::vector<ShapeKind>& shape_kinds() {
  static const std::vector<ShapeKind> kinds{circle_shape(), segment_shape(), arc_chain_shape(),
                                            cad_curve_shape()};
  return kinds;
}

const std::vector<SurfaceKind>& surface_kinds() {
  static const std::vector<SurfaceKind> kinds{sphere_shape(),  cylinder_shape(), cone_shape(),
                                              torus_shape(),   plane_shape(),    box_shape(),
                                              revolve_shape(), extrude_shape(),  cad_face_shape()};
  return kinds;
}

std::vector<Parameter> shape_parameters() {
  std::map<std::string, Parameter> all;
  for (const ShapeKind& kind : shape_kinds()) add(kind, all);
  for (const SurfaceKind& kind : surface_kinds()) add(kind, all);
  std::vector<Parameter> list;
  for (const auto& [name, parameter] : all) list.push_back(parameter);
  return list;
}

int shape_dimension(const Arguments& arguments) {
  return names_surface(arguments) || means_all_faces(arguments) ? 3 : 2;
}

std::shared_ptr<const Profile<2>> make_shape(const Arguments& arguments) {
  return chosen_of(shape_kinds(), arguments, "profile").make(arguments);
}

template <> std::shared_ptr<const Surface<2>> make_surface<2>(const Arguments& arguments) {
  const auto named = [&](const ShapeKind& kind) { return arguments.has(word_of(kind)); };
  if (std::none_of(shape_kinds().begin(), shape_kinds().end(), named))
    fail("shape", "give exactly one profile: " + examples(shape_kinds()) +
                      "; in space a surface: " + examples(surface_kinds()));
  return std::make_shared<ProfileSurface>(make_shape(arguments));
}

template <> std::shared_ptr<const Surface<3>> make_surface<3>(const Arguments& given) {
  Arguments arguments = given;
  if (arguments.has("faces") && arguments.list("faces").empty())
    fail("cad", "faces is an empty array: name faces, or leave it out to take all");
  if (!names_surface(arguments) && means_all_faces(arguments)) arguments.lists["faces"] = {};
  return chosen_of(surface_kinds(), arguments, "surface").make(arguments);
}

std::string shape_help() { return help_of(shape_kinds()) + help_of(surface_kinds()); }

} // namespace burnish
