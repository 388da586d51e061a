// Script type `tool`: profile, coordinates, motion or force of each coordinate.
//   tool roller(circle=R);                            also  inside=true, line=[x0,y0,x1,y1], name="roller"
//   roller.coordinates("polar", x=0, y=0);            or "cartesian"
//   roller.place("r", r0);  roller.move("phi", v);  roller.force("r", Q);      (load is a keyword of FreeFEM)
//   roller.value("r") present coordinate, roller.drive("r") generalized force received from the drive,
//   roller.q and roller.Q all of them as arrays, roller.name
#include "base/error.hpp"
#include "geometry/circle.hpp"
#include "geometry/segment.hpp"
#include "kinematics/cartesian.hpp"
#include "kinematics/polar.hpp"
#include "named.hpp"
#include "types.hpp"

namespace rigidcontact {
namespace {

struct Construct {
  static const int n = 4;
  static basicAC_F0::name_and_type names[n];
  static ToolHandle* call(const Named& named, ToolHandle* handle) {
    static int count = 0;
    handle->init();
    if (named.has("circle") == named.has("line"))
      burnish::fail("tool", "give exactly one profile: circle=R or line=[x0,y0,x1,y1]");
    std::shared_ptr<const burnish::Profile<2>> profile;
    if (named.has("circle")) {
      profile = std::make_shared<burnish::Circle>(named.real("circle", 0), named.boolean("inside", false));
    } else {
      const std::vector<double> p = named.list("line");
      burnish::require(p.size() == 4, "tool", "number of values in line", p.size(), "4: [x0,y0,x1,y1]");
      profile =
          std::make_shared<burnish::Segment>(burnish::Vector<2>(p[0], p[1]), burnish::Vector<2>(p[2], p[3]));
    }
    const std::string name = named.text("name", "tool " + std::to_string(++count));
    auto object = std::make_shared<ToolObject>();
    object->tool = std::make_shared<burnish::DrivenTool<2>>(name, profile);
    handle->set(std::move(object));
    return handle;
  }
};
basicAC_F0::name_and_type Construct::names[] = {{"circle", &typeid(double)},
                                                {"line", &typeid(E_Array)},
                                                {"inside", &typeid(bool)},
                                                {"name", &typeid(string*)}};

struct CoordinatesTag {};
using CoordinatesMethod = Method<ToolHandle, CoordinatesTag>;
struct Coordinates {
  static const int n = 2;
  static basicAC_F0::name_and_type names[n];
  static bool call(const Named& named, CoordinatesMethod m, string* kind) {
    std::shared_ptr<const burnish::Coordinates<2>> coordinates;
    if (*kind == "polar")
      coordinates =
          std::make_shared<burnish::Polar>(burnish::Vector<2>(named.real("x", 0), named.real("y", 0)));
    else if (*kind == "cartesian")
      coordinates = std::make_shared<burnish::Cartesian>();
    else
      burnish::fail("tool.coordinates",
                    "unknown kind \"" + *kind + "\", expected \"polar\" or \"cartesian\"");
    if (m->get().added)
      burnish::fail("tool.coordinates",
                    "tool \"" + m->get().tool->name() +
                        "\" belongs to a contact already: choose its coordinates before add");
    m->get().tool->set_coordinates(coordinates);
    return true;
  }
};
basicAC_F0::name_and_type Coordinates::names[] = {{"x", &typeid(double)}, {"y", &typeid(double)}};

struct PlaceTag {};
struct MoveTag {};
struct LoadTag {};
double place(const Method<ToolHandle, PlaceTag>& m, string* const& name, const double& value) {
  return guarded([&] {
    m->get().tool->place(*name, value);
    return value;
  });
}
double move(const Method<ToolHandle, MoveTag>& m, string* const& name, const double& value) {
  return guarded([&] {
    called("tool.move", [&] { m->get().tool->drive().move(*name, value); });
    return value;
  });
}
double load(const Method<ToolHandle, LoadTag>& m, string* const& name, const double& value) {
  return guarded([&] {
    called("tool.force", [&] { m->get().tool->drive().load(*name, value); });
    return value;
  });
}

struct ValueTag {};
struct ForceTag {};
double value_of(const Method<ToolHandle, ValueTag>& m, string* const& name) {
  return guarded([&] { return m->get().tool->q()[m->get().tool->index(*name)]; });
}
double force_of(const Method<ToolHandle, ForceTag>& m, string* const& name) {
  return guarded([&] { return m->get().tool->force()[m->get().tool->index(*name)]; });
}
KN_<double> all_q(Stack stack, ToolHandle* const& h) {
  return guarded([&] { return new_array(stack, h->get().tool->q()); });
}
KN_<double> all_force(Stack stack, ToolHandle* const& h) {
  return guarded([&] { return new_array(stack, h->get().tool->force()); });
}
string* name_of_tool(Stack stack, ToolHandle* const& h) { return new_string(stack, h->get().tool->name()); }

} // namespace

void register_tool() {
  Dcl_Type<ToolHandle*>(InitP<ToolHandle>, Destroy<ToolHandle>);
  zzzfff->Add("tool", atype<ToolHandle*>());
  TheOperators->Add("<-", new NamedOperator<Construct, ToolHandle*, ToolHandle*>);
  add_method<ToolHandle, CoordinatesTag>(
      "coordinates", [] { return new NamedOperator<Coordinates, bool, CoordinatesMethod, string*>; });
  add_method<ToolHandle, PlaceTag>("place", [] {
    return new OneOperator3_<double, Method<ToolHandle, PlaceTag>, string*, double>(place);
  });
  add_method<ToolHandle, MoveTag>(
      "move", [] { return new OneOperator3_<double, Method<ToolHandle, MoveTag>, string*, double>(move); });
  add_method<ToolHandle, LoadTag>(
      "force", [] { return new OneOperator3_<double, Method<ToolHandle, LoadTag>, string*, double>(load); });
  add_method<ToolHandle, ValueTag>(
      "value", [] { return new OneOperator2_<double, Method<ToolHandle, ValueTag>, string*>(value_of); });
  add_method<ToolHandle, ForceTag>(
      "drive", [] { return new OneOperator2_<double, Method<ToolHandle, ForceTag>, string*>(force_of); });
  Add<ToolHandle*>("q", ".", new OneOperator1s_<KN_<double>, ToolHandle*>(all_q));
  Add<ToolHandle*>("Q", ".", new OneOperator1s_<KN_<double>, ToolHandle*>(all_force));
  Add<ToolHandle*>("name", ".", new OneOperator1s_<string*, ToolHandle*>(name_of_tool));
}

} // namespace rigidcontact
