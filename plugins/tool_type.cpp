// Script type `tool`: profile, coordinates, motion or force of each coordinate.
//   > tool roller(circle=15e-3, name="roller");                 profiles: tool_shapes.cpp
//   > roller.coordinates("polar", pivot=[0, 0]);
//   > roller.place("r", 46e-3);  roller.move("phi", 1.6);  roller.force("r", -4e5);
//   tool(...)   declares a rigid tool; exactly one of circle=, line=, chain=, cad= gives its profile
//     name=     name in messages, files and "tool.coordinate" | | "tool 1", "tool 2", ... | no comma, quote, line break
//     ! give exactly one profile
//     ! , expected a text without comma, quote and line break
//   t.coordinates(kind)   the coordinates that place the tool's frame, once, before place, tightestradius and C.add; all begin at 0
//     kind      "cartesian": x, y, angle; "polar": r, phi, theta (its absolute turn); or names of one's own, separated by commas | length, rad
//     pivot=    polar: pole [x0, y0] | length | [0, 0]
//     x=        names of one's own: formula of the frame's x in coordinates and parameters | length | required
//     y=        the same of its y | length | required
//     angle=    the same of its turn, counter-clockwise | rad | "0"
//     > crank.coordinates("beta", x="e*cos(beta)", y="e*sin(beta)", angle="0");
//     ! , expected "polar", "cartesian", or names of coordinates with their formulas x=
//     ! belongs to a contact already: choose its coordinates before add
//     ! has its coordinates already:
//     ! lack the formula
//   t.parameter(name, value)   a number that formulas of coordinates and forces call by name; returns it | its own
//     name      name in the formulas
//     value     the number | its own | | finite
//   t.place(coordinate, value)   sets the present value of a coordinate, at the start or between runs; returns it
//     coordinate   its name
//     value     where to | length, rad | | finite
//     ! has no coordinate
//   t.move(coordinate, value)   prescribes the motion: the coordinate's value at the end of the step; returns it
//     coordinate   its name
//     value     at the end of the step | length, rad | | finite
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
#include "base/error.hpp"
#include "kinematics/cartesian.hpp"
#include "kinematics/cartesian_in_space.hpp"
#include "kinematics/formula_coordinates.hpp"
#include "kinematics/polar.hpp"
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

struct CoordinatesTag {};
using CoordinatesMethod = Method<ToolHandle, CoordinatesTag>;
struct ChooseCoordinates {
  static const int n = 4;
  static basicAC_F0::name_and_type names[n];
  static bool call(const Named& named, CoordinatesMethod m, string* kind) {
    return visit(m->get(), [&](auto& object) {
      const auto coordinates = made(named, *kind, object);
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

private:
  using Made = std::shared_ptr<const Coordinates<2>>;
  static Made made(const Named& named, const std::string& kind, const ToolOf<2>& object) {
    if (kind == "polar") return polar(named);
    return kind == "cartesian" ? cartesian(named) : by_formula(named, kind, object);
  }
  static std::shared_ptr<const Coordinates<3>> made(const Named&, const std::string& kind, const ToolOf<3>&) {
    if (kind == "cartesian") return std::make_shared<CartesianInSpace>();
    fail("tool.coordinates", "unknown kind \"" + kind + "\", expected \"cartesian\"");
  }
  static void refuse_formulas(const Named& named, const std::string& kind, const std::string& takes) {
    for (const char* formula : {"x", "y", "angle"})
      if (named.has(formula))
        fail("tool.coordinates", "\"" + kind + "\" takes " + takes + ", not " + formula +
                                     "=, which is a formula of coordinates named by the script");
  }
  static Made polar(const Named& named) {
    refuse_formulas(named, "polar", "pivot=[x0,y0]");
    if (!named.has("pivot")) return std::make_shared<Polar>();
    const std::vector<double> p = named.list("pivot");
    require(p.size() == 2, "tool.coordinates", "number of values in pivot", p.size(), "2: [x0,y0]");
    return std::make_shared<Polar>(Vector<2>(p[0], p[1]));
  }
  static void refuse_pivot(const Named& named, const std::string& kind) {
    if (named.has("pivot")) fail("tool.coordinates", "\"" + kind + "\" takes no pivot=, only \"polar\" does");
  }
  static Made cartesian(const Named& named) {
    refuse_formulas(named, "cartesian", "no more parameters");
    refuse_pivot(named, "cartesian");
    return std::make_shared<Cartesian>();
  }
  static Made by_formula(const Named& named, const std::string& list, const ToolOf<2>& object) {
    if (!named.has("x") && !named.has("y") && !named.has("angle"))
      fail("tool.coordinates",
           "unknown kind \"" + list +
               "\", expected \"polar\", \"cartesian\", or names of coordinates with their formulas x= "
               "and y=");
    refuse_pivot(named, list);
    for (const char* formula : {"x", "y"})
      if (!named.has(formula))
        fail("tool.coordinates", "coordinates \"" + list + "\" of tool \"" + object.tool->name() +
                                     "\" lack the formula " + formula + "=");
    const PlaneFormulas formulas{named.text("x", ""), named.text("y", ""), named.text("angle", "0")};
    return std::make_shared<FormulaCoordinates<2>>(object.tool->name(), coordinate_names(list), formulas,
                                                   object.tool->parameters());
  }
};
basicAC_F0::name_and_type ChooseCoordinates::names[] = {{"pivot", &typeid(E_Array)},
                                                        {"x", &typeid(string*)},
                                                        {"y", &typeid(string*)},
                                                        {"angle", &typeid(string*)}};

struct ToolParameterTag {};
double parameter(const Method<ToolHandle, ToolParameterTag>& m, string* const& name, const double& value) {
  return on(m.object, [&](auto& object) {
    object.tool->set_parameter(*name, value);
    return value;
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
double move(const Method<ToolHandle, MoveTag>& m, string* const& name, const double& value) {
  return on(m.object, [&](auto& object) {
    called("tool.move", [&] { object.tool->prescription().move(*name, value); });
    return value;
  });
}
double prescribe_force(const Method<ToolHandle, ForceTag>& m, string* const& name, const double& value) {
  return on(m.object, [&](auto& object) {
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

void register_tool() {
  Dcl_Type<ToolHandle*>(InitP<ToolHandle>, Destroy<ToolHandle>);
  zzzfff->Add("tool", atype<ToolHandle*>());
  TheOperators->Add("<-", new NamedOperator<MakeTool, ToolHandle*, ToolHandle*>);
  add_method<ToolHandle, CoordinatesTag>(
      "coordinates", [] { return new NamedOperator<ChooseCoordinates, bool, CoordinatesMethod, string*>; });
  add_method<ToolHandle, ToolParameterTag>("parameter", [] {
    return new OneOperator3_<double, Method<ToolHandle, ToolParameterTag>, string*, double>(parameter);
  });
  add_method<ToolHandle, PlaceTag>("place", [] {
    return new OneOperator3_<double, Method<ToolHandle, PlaceTag>, string*, double>(place);
  });
  add_method<ToolHandle, MoveTag>(
      "move", [] { return new OneOperator3_<double, Method<ToolHandle, MoveTag>, string*, double>(move); });
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
