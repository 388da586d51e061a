#pragma once
// Tools in space as scripts write them: every word for a shape, every kind of coordinates.
#include "kinematics/make_coordinates.hpp"
#include "shapes/shapes.hpp"

namespace burnish::test {

/// Named arguments, written as in a call.
class Call : public Arguments {
public:
  Call& number(const std::string& name, double value) {
    numbers[name] = value;
    return *this;
  }
  Call& list(const std::string& name, const std::vector<double>& value) {
    lists[name] = value;
    return *this;
  }
  Call& text(const std::string& name, const std::string& value) {
    texts[name] = value;
    return *this;
  }
  Call& flag(const std::string& name, bool value = true) {
    flags[name] = value;
    return *this;
  }
};

struct NamedCall {
  std::string name;
  Call arguments;
};

inline std::vector<NamedCall> shape_calls() {
  const std::vector<double> die{0, 0, 0, 2, 0, 0.8, 2.5, 2, 0.4, 5, 2.5, 0}; // from the axis outwards
  const std::vector<double> back{5, 2.5, 0, 2.5, 2, 0.4, 2, 0, 0.8, 0, 0, 0};
  const std::vector<double> kidney{1, 0, 0.5, 7, -1, 1.1, 8, 3, 0.6, 4.2, 2.2, 0.7, 2, 5, 0.9};
  return {
      {"sphere", Call().number("sphere", 2.5)},
      {"hollow sphere", Call().number("sphere", 2.5).flag("inside")},
      {"endless cylinder", Call().number("cylinder", 1.5)},
      {"cylinder",
       Call().number("cylinder", 1.5).number("length", 4).number("fillet", 0.4).list("axis", {1, 2, 3})},
      {"hollow cylinder",
       Call().number("cylinder", 1.5).number("length", 4).number("fillet", 0.4).flag("inside")},
      {"cone", Call().list("cone", {2.5, 1, 2}).number("fillet", 0.3)},
      {"tip", Call().list("cone", {2, 0, 3}).number("fillet", 0.3).list("axis", {0, -1, 0})},
      {"torus", Call().list("torus", {3, 1.2}).list("axis", {1, 0, 1})},
      {"plane", Call().list("plane", {0.3, -1, 0.7, 1, 2, -2})},
      {"box", Call().list("box", {4, 3, 2.5}).number("fillet", 0.4)},
      {"hollow box", Call().list("box", {4, 3, 2.5}).number("fillet", 0.4).flag("inside")},
      {"turned chain", Call().list("chain", back).flag("revolve")},
      {"hollow turned chain", Call().list("chain", die).flag("revolve").list("axis", {1, 1, 1})},
      {"turned circle", Call().number("circle", 1.5).flag("revolve")},
      {"endless bar", Call().list("line", {-1, 2, 3, 5}).flag("extrude").list("axis", {0, 1, 0})},
      {"bar", Call().list("line", {-1, 2, 3, 5}).flag("extrude").number("length", 4)},
      {"prism",
       Call().list("chain", kidney).flag("closed").flag("extrude").number("length", 3).number("fillet", 0.3)},
      {"step prism", Call()
                         .text("cad", "tests/support/cad/lobe.step")
                         .number("scale", 0.3)
                         .flag("extrude")
                         .number("length", 3)
                         .number("fillet", 0.1)},
      {"CAD body", Call().text("cad", "tests/support/cad/rounded.step").number("scale", 0.5)}};
}

struct CoordinatesCall {
  std::string name, kind;
  Call arguments;
  std::vector<double> q; ///< somewhere
};

inline std::vector<CoordinatesCall> coordinates_calls() {
  const Call line = Call().list("pivot", {0.3, -1.1, 0.7}).list("axis", {1, 2, -2});
  return {
      {"cartesian", "cartesian", Call(), {1, -2, 0.5, 0.4, -0.8, 1.1}},
      {"Euler's angles",
       "cartesian",
       Call().text("rotation", "z:phi x:theta z:psi"),
       {1, 2, 3, 0.4, 1.2, -0.6}},
      {"rotation vector", "cartesian", Call().text("rotation", "vector: a, b, c"), {1, 2, 3, 0.4, 1.2, -0.6}},
      {"quaternion",
       "cartesian",
       Call().text("rotation", "quaternion: w, a, b, c"),
       {1, 2, 3, 0.3, -0.5, 0.8, 1.1}},
      {"polar", "polar", line, {1.5, 0.4, -2, 3}},
      {"screw", "screw", Call(line).number("lead", 2.5), {0.7}},
      {"of one's own",
       "h, phi, tilt",
       Call().text("x", "e").text("y", "h*phi").text("z", "h").text("rotation", "[1 1 e]:phi x:tilt-h"),
       {0.6, -1.3, 0.4}}};
}

inline std::shared_ptr<const Coordinates<3>> coordinates_of(const CoordinatesCall& call) {
  return make_coordinates<3>("tool", call.kind, call.arguments, {{"e", 0.3}});
}

} // namespace burnish::test
