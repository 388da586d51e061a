#include "kinematics/make_coordinates.hpp"
#include "base/error.hpp"
#include "formula/formula_tokens.hpp"
#include "kinematics/cartesian.hpp"
#include "kinematics/cartesian_in_space.hpp"
#include "kinematics/formula_coordinates.hpp"
#include "kinematics/polar.hpp"
#include "kinematics/polar_in_space.hpp"
#include "kinematics/screw.hpp"
#include "kinematics/sized_coordinates.hpp"
#include <algorithm>
#include <functional>

namespace burnish {
namespace {

constexpr const char* WHERE = "tool.coordinates";
using Names = std::vector<std::string>;

bool among(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// What a script says of a tool's coordinates.
struct Said {
  const std::string &tool, &kind;
  const Arguments& given;
  const std::map<std::string, double>& parameters;
  const Names& following;

  template <int Dim>
  Vector<Dim> vector(const char* name, const Vector<Dim>& otherwise, const char* expected) const {
    if (!given.has(name)) return otherwise;
    const std::vector<double> v = given.list(name);
    const std::string what = std::string("number of values in ") + name;
    require(v.size() == Dim, WHERE, what.c_str(), v.size(), expected);
    return Eigen::Map<const Vector<Dim>>(v.data());
  }
  /// Of polar coordinates and the screw in space.
  AxisFrame line() const {
    AxisFrame axis = turned_frame(WHERE, vector<3>("axis", Vector<3>::UnitZ(), "3: [x,y,z]"));
    axis.point = vector<3>("pivot", Vector<3>::Zero(), "3: [x0,y0,z0]");
    require(axis.point.allFinite(), WHERE, "pivot", axis.point.transpose(), "finite components");
    return axis;
  }
};

template <int Dim> struct Kind {
  using Made = std::shared_ptr<const Coordinates<Dim>>;
  std::string name; ///< empty: the names of one's own
  Names takes;
  std::string shown; ///< what it takes, for messages
  std::function<Made(const Said&)> make;
};

// Adds the words of a formula that nobody else explains.
void add_names(const Said& said, const std::string& formula, Names& names) {
  const Names constants{"pi", "Pi", "I", "Euler", "Catalan"};
  std::vector<FormulaToken> tokens;
  try {
    tokens = formula_tokens(formula);
  } catch (const std::invalid_argument&) { // Formula says what is wrong
    return;
  }
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const std::string& word = tokens[i].text;
    const bool call = i + 1 < tokens.size() && tokens[i + 1].kind == FormulaToken::Kind::OPEN;
    if (tokens[i].kind != FormulaToken::Kind::WORD || call || said.parameters.count(word) > 0) continue;
    if (!among(constants, word) && !among(names, word)) names.push_back(word);
  }
}

// Those of the formulas of a rotation.
Names names_of_rotation(const Said& said, const std::string& text) {
  Names names;
  const std::string where = "rotation of tool \"" + said.tool + "\"";
  for (const FormulaText& number : rotation_formulas(where, text, said.parameters).numbers)
    add_names(said, number.text, names);
  return names;
}

// The coordinates of the script, but those that size= alone names, and the parameters that follow t and move the frame.
Names names_of_frame(const Said& said) {
  if (!said.given.has("size") && said.following.empty()) return coordinate_names(said.kind);
  Names frame, size;
  if (said.given.has("rotation")) frame = names_of_rotation(said, said.given.text("rotation"));
  for (const char* formula : {"x", "y", "z", "angle"})
    if (said.given.has(formula)) add_names(said, said.given.text(formula), frame);
  if (said.given.has("size")) add_names(said, said.given.text("size"), size);
  Names names;
  for (const std::string& name : coordinate_names(said.kind))
    if (among(frame, name) || !among(size, name)) names.push_back(name);
  for (const std::string& name : said.following)
    if (among(frame, name) && !among(names, name)) names.push_back(name);
  return names;
}

std::shared_ptr<const Coordinates<3>> cartesian_in_space(const Said& said) {
  const std::string rotation = said.given.text("rotation");
  if (!said.given.has("rotation")) return std::make_shared<CartesianInSpace>();
  Names names{"x", "y", "z"};
  for (const std::string& name : names_of_rotation(said, rotation))
    if (!among(names, name)) names.push_back(name);
  return std::make_shared<FormulaCoordinates<3>>(said.tool, names, SpaceFormulas{"x", "y", "z", rotation},
                                                 said.parameters);
}

void require_formulas(const Said& said, const Names& formulas) {
  for (const std::string& formula : formulas)
    if (!said.given.has(formula))
      fail(WHERE, "coordinates \"" + said.kind + "\" of tool \"" + said.tool + "\" lack the formula " +
                      formula + "=");
}

template <int Dim> const std::vector<Kind<Dim>>& kinds();
template <> const std::vector<Kind<2>>& kinds<2>() {
  static const std::vector<Kind<2>> all{
      {"polar",
       {"pivot"},
       "pivot=[x0,y0]",
       [](const Said& said) {
         return std::make_shared<Polar>(said.vector<2>("pivot", Vector<2>::Zero(), "2: [x0,y0]"));
       }},
      {"cartesian", {}, "no more parameters", [](const Said&) { return std::make_shared<Cartesian>(); }},
      {"", {"x", "y", "angle"}, "x=, y= and angle=", [](const Said& said) {
         require_formulas(said, {"x", "y"});
         const std::string angle = said.given.has("angle") ? said.given.text("angle") : "0";
         return std::make_shared<FormulaCoordinates<2>>(
             said.tool, names_of_frame(said),
             PlaneFormulas{said.given.text("x"), said.given.text("y"), angle}, said.parameters);
       }}};
  return all;
}
template <> const std::vector<Kind<3>>& kinds<3>() {
  static const std::vector<Kind<3>> all{
      {"polar",
       {"pivot", "axis"},
       "pivot=[x0,y0,z0] and axis=[x,y,z]",
       [](const Said& said) { return std::make_shared<PolarInSpace>(said.line()); }},
      {"cartesian", {"rotation"}, "rotation=", cartesian_in_space},
      {"screw",
       {"pivot", "axis", "lead"},
       "pivot=[x0,y0,z0], axis=[x,y,z] and lead=",
       [](const Said& said) {
         if (!said.given.has("lead"))
           fail(WHERE,
                "\"screw\" of tool \"" + said.tool + "\" lacks lead=, the way along the axis of a full turn");
         return std::make_shared<Screw>(said.line(), said.given.number("lead", 0));
       }},
      {"", {"x", "y", "z", "rotation"}, "x=, y=, z= and rotation=", [](const Said& said) {
         require_formulas(said, {"x", "y", "z"});
         return std::make_shared<FormulaCoordinates<3>>(
             said.tool, names_of_frame(said),
             SpaceFormulas{said.given.text("x"), said.given.text("y"), said.given.text("z"),
                           said.given.text("rotation")},
             said.parameters);
       }}};
  return all;
}

// "polar" does, or "polar" and "screw" do.
template <int Dim> std::string takers(const std::string& parameter) {
  std::string list;
  int count = 0;
  for (const Kind<Dim>& kind : kinds<Dim>())
    if (!kind.name.empty() && among(kind.takes, parameter))
      list += (count++ ? " and \"" : "\"") + kind.name + "\"";
  return list + (count > 1 ? " do" : " does");
}

template <int Dim> void refuse_others(const Kind<Dim>& kind, const Said& said) {
  const Names& own = kinds<Dim>().back().takes;
  for (const Parameter& parameter : coordinate_parameters()) {
    const std::string& name = parameter.name;
    if (!said.given.has(name) || name == "size" || among(kind.takes, name)) continue;
    const auto known = [&](const Kind<Dim>& other) { return among(other.takes, name); };
    if (std::none_of(kinds<Dim>().begin(), kinds<Dim>().end(), known))
      fail(WHERE, "tool \"" + said.tool + "\" is one of " + (Dim == 2 ? "the plane" : "space") +
                      " and takes no " + name + "=" +
                      (name == "angle"      ? ", but rotation="
                       : name == "rotation" ? ", but angle="
                                            : ""));
    if (among(own, name))
      fail(WHERE, "\"" + said.kind + "\" takes " + kind.shown + ", not " + name +
                      "=, which is a formula of coordinates named by the script");
    fail(WHERE, "\"" + said.kind + "\" takes no " + name + "=, only " + takers<Dim>(name));
  }
}

// Coordinates of a frame with the size of the tool, if the script gives one.
template <int Dim>
std::shared_ptr<const Coordinates<Dim>> sized(const Said& said,
                                              std::shared_ptr<const Coordinates<Dim>> frame) {
  Names names = frame->names();
  if (said.given.has("size")) {
    add_names(said, said.given.text("size"), names);
    frame = std::make_shared<SizedCoordinates<Dim>>(said.tool, std::move(frame), names,
                                                    said.given.text("size"), said.parameters);
  }
  for (const std::string& name : said.following)
    if (!among(names, name))
      fail(WHERE, "parameter \"" + name + "\" of tool \"" + said.tool +
                      "\" follows t, but no formula of its coordinates names it");
  return frame;
}

template <int Dim> [[noreturn]] void unknown(const Said& said) {
  std::string known;
  for (const Kind<Dim>& kind : kinds<Dim>())
    if (!kind.name.empty()) known += "\"" + kind.name + "\", ";
  fail(WHERE, "unknown kind \"" + said.kind + "\", expected " + known +
                  "or names of coordinates with their formulas " +
                  (Dim == 2 ? "x= and y=" : "x=, y= and z="));
}

} // namespace

const std::vector<Parameter>& coordinate_parameters() {
  static const std::vector<Parameter> list{
      {"pivot", ArgumentKind::NUMBERS,
       "polar: pole [x0,y0]; in space a point of the line, also of a screw [length]"},
      {"axis", ArgumentKind::NUMBERS, "polar and screw in space: direction of the line; z unless given"},
      {"lead", ArgumentKind::NUMBER,
       "screw: way along the line of a full turn, negative for a left-hand thread [length]"},
      {"x", ArgumentKind::TEXT, "names of one's own: formula of the frame's x [length]"},
      {"y", ArgumentKind::TEXT, "the same of its y [length]"},
      {"z", ArgumentKind::TEXT, "the same of its z, in space [length]"},
      {"angle", ArgumentKind::TEXT, "the same of its turn in the plane, counter-clockwise [rad]"},
      {"rotation", ArgumentKind::TEXT,
       "in space \"z:phi x:theta z:psi\", \"vector: a, b, c\" or \"quaternion: w, a, b, c\", each a formula "
       "[rad, -]"},
      {"size", ArgumentKind::TEXT,
       "all kinds: formula of the tool's size over that of its shape; names that are no parameters are "
       "coordinates [-]"}};
  return list;
}

template <int Dim>
std::shared_ptr<const Coordinates<Dim>>
make_coordinates(const std::string& tool, const std::string& kind, const Arguments& given,
                 const std::map<std::string, double>& parameters, const std::vector<std::string>& following) {
  const Said said{tool, kind, given, parameters, following};
  const auto& all = kinds<Dim>();
  const auto named = [&](const Kind<Dim>& known) { return known.name == kind && !kind.empty(); };
  const auto found = std::find_if(all.begin(), all.end(), named);
  const Kind<Dim>& chosen = found == all.end() ? all.back() : *found;
  const auto has = [&](const std::string& name) { return given.has(name); };
  if (chosen.name.empty() && std::none_of(chosen.takes.begin(), chosen.takes.end(), has)) unknown<Dim>(said);
  refuse_others(chosen, said);
  return sized<Dim>(said, chosen.make(said));
}

template std::shared_ptr<const Coordinates<2>> make_coordinates<2>(const std::string&, const std::string&,
                                                                   const Arguments&,
                                                                   const std::map<std::string, double>&,
                                                                   const std::vector<std::string>&);
template std::shared_ptr<const Coordinates<3>> make_coordinates<3>(const std::string&, const std::string&,
                                                                   const Arguments&,
                                                                   const std::map<std::string, double>&,
                                                                   const std::vector<std::string>&);

} // namespace burnish
