// Script type `tool`: shape, coordinates, motion or force of each coordinate.
//   > tool roller(circle=15e-3, name="roller");                 shapes: tool_shapes.cpp
//   > roller.coordinates("polar", pivot=[0, 0]);
//   > roller.place("r", 46e-3);  roller.move("phi", 1.6);  roller.force("r", -4e5);
//   tool(...)   declares a rigid tool: of the plane by exactly one of circle=, line=, chain=, cad=; of space by exactly one of
//       sphere=, cylinder=, cone=, torus=, plane=, box=, or by revolve= or extrude= with one of the former
//     name=     name in messages, files and "tool.coordinate" | | "tool 1", "tool 2", ... | no comma, quote, line break
//     ! give exactly one profile
//     ! give exactly one
//     ! , expected a text without comma, quote and line break
//   t.coordinates(kind)   the coordinates that place the tool's frame, once, before place, tightestradius and C.add; all begin at 0.
//       In space the spins of "cartesian" turn about the directions of space from where the tool is, so that no pose is
//       singular, and their forces are the moments about the frame's origin; turns about several axes do not commute
//     kind      "cartesian": x, y, angle; "polar": r, phi, theta (its absolute turn); in space "cartesian": x, y, z, spinx,
//       spiny, spinz, or with rotation= x, y, z and its names; "polar": r, phi, z, theta about a line; "screw": phi; or names of
//       one's own, separated by commas | length, rad
//     pivot=    polar: pole [x0, y0]; in space of polar and screw: point of the line [x0, y0, z0] | length | 0
//     axis=     polar, screw in space: direction of the line [x, y, z]; phi = 0 is along x of the frame turned the shortest way
//       from z to it | - | [0, 0, 1] | not all 0
//     lead=     screw: way along the line of a full turn | length | required
//     x=        names of one's own: formula of the frame's x in coordinates and parameters | length | required
//     y=        the same of its y | length | required
//     z=        the same of its z, in space | length | required
//     angle=    the same of its turn in the plane, counter-clockwise | rad | "0"
//     rotation=   the same of its rotation in space: turns one after the other about axes of the frame turned so far,
//       "z:phi x:theta z:psi", "[1 1 0]:phi"; "vector: a, b, c"; "quaternion: w, a, b, c" of any length but 0 | rad, - | none
//     size=     all kinds: formula of the size of the tool, over that of its shape: every length of the shape is so many times as
//       long. Names that are no parameters are coordinates, last of all; their forces do work as it grows | - | none | > 0
//     > roll.coordinates("cartesian", size="R");
//     > crank.coordinates("beta", x="e*cos(beta)", y="e*sin(beta)", angle="0");
//     > ball.coordinates("cartesian");
//     > plate.coordinates("cartesian", rotation="z:phi x:theta z:psi");
//     ! or names of coordinates with their formulas
//     ! belongs to a contact already: choose its coordinates before add
//     ! has its coordinates already:
//     ! lack the formula
//     ! lacks lead=, the way along the axis of a full turn
//     ! depends on no coordinate, expected a name
//     ! the quaternion has the length 0, expected a direction
//     ! whose spins have no singular pose
//   t.parameter(name, value)   a number that formulas of coordinates and forces call by name; returns it | its own
//     name      name in the formulas
//     value     number, or text: a formula of t; the name is a coordinate then, of this motion and with a force, and begins at its
//       value at t = 0; before coordinates | its own | | finite
//     > roll.parameter("R", "5 + 0.1*t");
//     ! comes too late
//     ! follows t, but no formula of its coordinates names it
//   t.place(coordinate, value)   sets the present value of a coordinate, at the start or between runs; returns it
//     coordinate   its name
//     value     where to | length, rad | | finite
//     ! has no coordinate
//   t.move(coordinate, value)   prescribes the motion: the coordinate's value at the end of the step; returns it
//     coordinate   its name
//     value     at the end of the step: number, or text: a formula of t and of the tool's parameters | length, rad | | finite
//     > roller.move("phi", "1.6*t");
//     ! and takes neither motion nor force of its own: prescribe what it follows
//   t.force(coordinate, value)   prescribes the generalized force that the drive exerts, positive along the growing coordinate
//     coordinate   its name
//     value     number, or text: a formula of the tool's coordinates, parameters and t | force, force*length | | finite
//     > roller.force("y", "-k*(y - y0)");
//     ! has no coordinate
//   t.force(coordinate)   the generalized force on it, of the accepted state | force, force*length
//     coordinate   its name
//   t.value(coordinate)   present value | length, rad
//     coordinate   its name
//   t.q         present values of all coordinates, in their order | length, rad
//   t.Q         generalized forces on them | force, force*length
//   t.name      name of the tool
#include "arguments.hpp"
#include "base/error.hpp"
#include "kinematics/make_coordinates.hpp"
#include "named.hpp"
#include "tool_shapes.hpp"
#include "types.hpp"

namespace burnish {
namespace {

template <int Dim>
std::shared_ptr<ToolObject> tool_with(const std::string& name, std::shared_ptr<const Surface<Dim>> surface) {
  auto object = std::make_shared<ToolOf<Dim>>();
  object->tool = std::make_shared<DrivenTool<Dim>>(name, std::move(surface));
  return object;
}
struct MakeTool {
  static std::vector<basicAC_F0::name_and_type> list;
  static const int n;
  static basicAC_F0::name_and_type* const names;
  static ToolHandle* call(const Named& named, ToolHandle* handle) {
    static int count = 0;
    handle->init();
    const std::string name = named.text("name", "tool " + std::to_string(++count));
    std::visit([&](auto surface) { handle->set(tool_with(name, std::move(surface))); }, shape_of(named));
    return handle;
  }
};
std::vector<basicAC_F0::name_and_type> MakeTool::list = shape_names({{"name", &typeid(string*)}});
const int MakeTool::n = static_cast<int>(list.size());
basicAC_F0::name_and_type* const MakeTool::names = list.data();

template <int Dim> std::vector<std::string> following_of(const DrivenTool<Dim>& tool) {
  std::vector<std::string> names;
  for (const auto& [name, text] : tool.following()) names.push_back(name);
  return names;
}

struct CoordinatesTag {};
using CoordinatesMethod = Method<ToolHandle, CoordinatesTag>;
struct ChooseCoordinates {
  static std::vector<basicAC_F0::name_and_type> list;
  static const int n;
  static basicAC_F0::name_and_type* const names;
  static bool call(const Named& named, CoordinatesMethod m, string* kind) {
    return visit(m->get(), [&](auto& object) {
      const auto coordinates = make_coordinates<dim_of<decltype(object)>>(
          object.tool->name(), *kind, arguments_of(named, coordinate_parameters()), object.tool->parameters(),
          following_of(*object.tool));
      if (object.added)
        fail("tool.coordinates", "tool \"" + object.tool->name() +
                                     "\" belongs to a contact already: choose its coordinates before add");
      if (object.tool->shared_tool())
        fail("tool.coordinates", "tool \"" + object.tool->name() + "\" has its coordinates already: " +
                                     joined(object.tool->tool().coordinates().names()));
      object.tool->set_coordinates(coordinates);
      return true;
    });
  }
};
std::vector<basicAC_F0::name_and_type> ChooseCoordinates::list = names_of(coordinate_parameters(), {});
const int ChooseCoordinates::n = static_cast<int>(list.size());
basicAC_F0::name_and_type* const ChooseCoordinates::names = list.data();

struct ToolParameterTag {};
double parameter(const Method<ToolHandle, ToolParameterTag>& m, string* const& name, const double& value) {
  return on(m.object, [&](auto& object) {
    object.tool->set_parameter(*name, value);
    return value;
  });
}

double whole_parameter(const Method<ToolHandle, ToolParameterTag>& m, string* const& name,
                       const long& value) {
  return parameter(m, name, static_cast<double>(value));
}
double following_parameter(const Method<ToolHandle, ToolParameterTag>& m, string* const& name,
                           string* const& text) {
  return on(m.object, [&](auto& object) {
    object.tool->set_parameter(*name, *text);
    return 0.;
  });
}

struct PlaceTag {};
struct MoveTag {};
struct ForceTag {};
double place(const Method<ToolHandle, PlaceTag>& m, string* const& name, const double& value) {
  return on(m.object, [&](auto& object) {
    object.tool->place(*name, value);
    return value;
  });
}
template <class Object> void note_driven(const Object& object) {
  if (!object.added) tools_of_no_contact().insert(object.tool->name());
}
double move(const Method<ToolHandle, MoveTag>& m, string* const& name, const double& value) {
  return on(m.object, [&](auto& object) {
    note_driven(object);
    called("tool.move", [&] { object.tool->prescription().move(*name, value); });
    return value;
  });
}
double move_whole(const Method<ToolHandle, MoveTag>& m, string* const& name, const long& value) {
  return move(m, name, static_cast<double>(value));
}
double move_by_formula(const Method<ToolHandle, MoveTag>& m, string* const& name, string* const& text) {
  return on(m.object, [&](auto& object) {
    note_driven(object);
    called("tool.move", [&] { object.tool->move(*name, *text); });
    return 0.;
  });
}
double prescribe_force(const Method<ToolHandle, ForceTag>& m, string* const& name, const double& value) {
  return on(m.object, [&](auto& object) {
    note_driven(object);
    called("tool.force", [&] { object.tool->prescription().force(*name, value); });
    return value;
  });
}

// A whole number could become a text as well as a real number.
double prescribe_whole_force(const Method<ToolHandle, ForceTag>& m, string* const& name, const long& value) {
  return prescribe_force(m, name, static_cast<double>(value));
}
double prescribe_formula(const Method<ToolHandle, ForceTag>& m, string* const& name, string* const& text) {
  return on(m.object, [&](auto& object) {
    note_driven(object);
    called("tool.force", [&] { object.tool->force(*name, *text); });
    return 0.;
  });
}

struct ToolValueTag {};
double value_of(const Method<ToolHandle, ToolValueTag>& m, string* const& name) {
  return on(m.object, [&](auto& object) { return object.tool->q()[object.tool->index(*name)]; });
}
double force_of(const Method<ToolHandle, ForceTag>& m, string* const& name) {
  return on(m.object,
            [&](auto& object) { return object.tool->generalized_force()[object.tool->index(*name)]; });
}
KN_<double> all_q(Stack stack, ToolHandle* const& h) {
  return on(h, [&](auto& object) { return new_array(stack, object.tool->q()); });
}
KN_<double> all_force(Stack stack, ToolHandle* const& h) {
  return on(h, [&](auto& object) { return new_array(stack, object.tool->generalized_force()); });
}
string* name_of_tool(Stack stack, ToolHandle* const& h) {
  return on(h, [&](auto& object) { return new_string(stack, object.tool->name()); });
}

} // namespace

std::set<std::string>& tools_of_no_contact() {
  static auto* names = new std::set<std::string>; // read when the program exits, after destructors
  return *names;
}

void register_tool() {
  Dcl_Type<ToolHandle*>(InitP<ToolHandle>, Destroy<ToolHandle>);
  zzzfff->Add("tool", atype<ToolHandle*>());
  TheOperators->Add("<-", new NamedOperator<MakeTool, ToolHandle*, ToolHandle*>);
  add_method<ToolHandle, CoordinatesTag>(
      "coordinates", [] { return new NamedOperator<ChooseCoordinates, bool, CoordinatesMethod, string*>; });
  using ParameterMethod = Method<ToolHandle, ToolParameterTag>;
  add_method<ToolHandle, ToolParameterTag>(
      "parameter", [] { return new OneOperator3_<double, ParameterMethod, string*, double>(parameter); },
      [] { return new OneOperator3_<double, ParameterMethod, string*, long>(whole_parameter); },
      [] { return new OneOperator3_<double, ParameterMethod, string*, string*>(following_parameter); });
  add_method<ToolHandle, PlaceTag>("place", [] {
    return new OneOperator3_<double, Method<ToolHandle, PlaceTag>, string*, double>(place);
  });
  add_method<ToolHandle, MoveTag>(
      "move", [] { return new OneOperator3_<double, Method<ToolHandle, MoveTag>, string*, double>(move); },
      [] { return new OneOperator3_<double, Method<ToolHandle, MoveTag>, string*, long>(move_whole); },
      [] {
        return new OneOperator3_<double, Method<ToolHandle, MoveTag>, string*, string*>(move_by_formula);
      });
  add_method<ToolHandle, ForceTag>(
      "force",
      [] {
        return new OneOperator3_<double, Method<ToolHandle, ForceTag>, string*, double>(prescribe_force);
      },
      [] {
        return new OneOperator3_<double, Method<ToolHandle, ForceTag>, string*, long>(prescribe_whole_force);
      },
      [] {
        return new OneOperator3_<double, Method<ToolHandle, ForceTag>, string*, string*>(prescribe_formula);
      },
      [] { return new OneOperator2_<double, Method<ToolHandle, ForceTag>, string*>(force_of); });
  add_method<ToolHandle, ToolValueTag>(
      "value", [] { return new OneOperator2_<double, Method<ToolHandle, ToolValueTag>, string*>(value_of); });
  Add<ToolHandle*>("q", ".", new OneOperator1s_<KN_<double>, ToolHandle*>(all_q));
  Add<ToolHandle*>("Q", ".", new OneOperator1s_<KN_<double>, ToolHandle*>(all_force));
  Add<ToolHandle*>("name", ".", new OneOperator1s_<string*, ToolHandle*>(name_of_tool));
}

} // namespace burnish
