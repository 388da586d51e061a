#include "shapes/shapes.hpp"
#include "base/error.hpp"
#include "cad/cad_selection.hpp"
#include "geometry/arc_chain.hpp"
#include "geometry/circle.hpp"
#include "geometry/segment.hpp"
#include <algorithm>

namespace burnish {

namespace {

bool takes(const ShapeKind& kind, const std::string& name) {
  const auto named = [&](const Parameter& parameter) { return parameter.name == name; };
  return std::any_of(kind.parameters.begin(), kind.parameters.end(), named);
}

std::string examples() {
  std::string text;
  const auto& kinds = shape_kinds();
  for (std::size_t i = 0; i < kinds.size(); ++i)
    text += (i == 0 ? "" : i + 1 < kinds.size() ? ", " : " or ") + kinds[i].example;
  return text;
}

} // namespace

const std::vector<ShapeKind>& shape_kinds() {
  static const std::vector<ShapeKind> kinds{circle_shape(), segment_shape(), arc_chain_shape(),
                                            cad_curve_shape()};
  return kinds;
}

std::vector<Parameter> shape_parameters() {
  std::map<std::string, Parameter> all;
  for (const ShapeKind& kind : shape_kinds())
    for (const Parameter& parameter : kind.parameters) all.emplace(parameter.name, parameter);
  std::vector<Parameter> list;
  for (const auto& [name, parameter] : all) list.push_back(parameter);
  return list;
}

std::shared_ptr<const Profile<2>> make_shape(const Arguments& arguments) {
  const ShapeKind* chosen = nullptr;
  int count = 0;
  for (const ShapeKind& kind : shape_kinds()) {
    if (!arguments.has(kind.parameters[0].name)) continue;
    chosen = &kind;
    ++count;
  }
  if (count != 1) fail("shape", "give exactly one profile: " + examples());
  for (const Parameter& other : shape_parameters())
    if (arguments.has(other.name) && !takes(*chosen, other.name))
      fail("shape", chosen->parameters[0].name + "= takes no " + other.name + "=" + chosen->remark);
  return chosen->make(arguments);
}

std::string shape_help() {
  std::string text;
  for (const ShapeKind& kind : shape_kinds())
    for (const Parameter& parameter : kind.parameters) {
      const bool first = &parameter == &kind.parameters[0];
      std::string left = first ? kind.example : "    " + parameter.name + "=";
      left.resize(std::max<std::size_t>(left.size() + 2, 34), ' ');
      text += left + parameter.help + "\n";
    }
  return text;
}

} // namespace burnish
