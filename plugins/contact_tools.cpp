// What a script reads of the tools of a contact, i = 0 .. C.toolnumber-1 in the order of C.add, accepted state.
//   C.dimension   2 or 3: of the workpiece | -
//   C.toolnumber   how many | -
//   C.toolname(i)   name of tool i
//     i         tool | - | | 0 to toolnumber-1
//   C.coordinates   names "x,y,angle"; with several tools "upper.x,upper.y,...,lower.x,..."
//   C.q         coordinates in that order | length, rad
//   C.Q         generalized forces on them | force, force*length
//   C.drive(k)   what the program prescribes for coordinate k of that order: "motion", "force", "follows"; "": nothing yet
//     k         coordinate | - | | 0 to their number - 1
//   C.twist(k)   velocity of the tool's frame and its angular velocity for a unit rate of coordinate k: x, y, angle; in space x, y, z,
//       then about x, y, z | its own
//     k         coordinate | - | | 0 to their number - 1
//   C.countof(state, i)   number of nodes of tool i in a state | -
//     state     as in C.count
//     i         tool | - | | 0 to toolnumber-1
//   C.toolforcex(i), C.toolforcey(i), C.toolforcez(i)   resultant of the contact forces on tool i; z in space | force
//     i         tool | - | | 0 to toolnumber-1
//   C.outlinex(i, n), C.outliney(i, n)   outline of tool i: n points and its joints; n = 0: as many as a picture of the
//       workpiece needs, more where it bends and is seen | length
//     i         tool | - | | 0 to toolnumber-1
//     n         number of points | - | | 0, 2 to 1000000
//   C.toolsurface(i)   in space: triangles of tool i where it is, near the workpiece, a meshS for FreeFEM's plot
//     i         tool | - | | 0 to toolnumber-1
//   C.nodetool   over the candidates: tool in contact, or the last one; -1 none | -
#include "base/error.hpp"
#include "contact/tool_report.hpp"
#include "kinematics/outline.hpp"
#include "kinematics/twist.hpp"
#include "named.hpp"
#include "output/contact_files.hpp"
#include "types.hpp"

namespace burnish {
namespace {

using H = ContactHandle;

// FreeFEM's mesh of these triangles, without the points that none of them has; it goes with the stack.
pmeshS surface_mesh_of(Stack stack, const SurfaceMesh& mesh) {
  using namespace Fem2D;
  constexpr int UNUSED = -1;
  std::vector<int> number(mesh.points.size(), UNUSED), used;
  for (const auto& triangle : mesh.triangles)
    for (const int point : triangle)
      if (number[point] == UNUSED) {
        number[point] = static_cast<int>(used.size());
        used.push_back(point);
      }
  const int points = static_cast<int>(used.size()), triangles = static_cast<int>(mesh.triangles.size());
  auto* places = new Vertex3[points];
  auto* faces = new TriangleS[triangles];
  for (int i = 0; i < points; ++i) {
    const auto& x = mesh.points[used[i]];
    static_cast<R3&>(places[i]) = R3(x[0], x[1], x[2]);
  }
  for (int k = 0; k < triangles; ++k) {
    const auto& [a, b, c] = mesh.triangles[k];
    int corners[] = {number[a], number[b], number[c]};
    faces[k].set(places, corners, 0);
  }
  return Add2StackOfPtr2FreeRC(stack, new MeshS(points, triangles, 0, places, faces, nullptr));
}

template <int Dim> int tool_index(const ContactSetup<Dim>& s, long i, const char* where) {
  const long n = static_cast<long>(s.tools().size());
  require(i >= 0 && i < n, where, "tool", i, ("0 to toolnumber-1 = " + std::to_string(n - 1)).c_str());
  return static_cast<int>(i);
}
template <int Dim> std::vector<std::shared_ptr<const Tool<Dim>>> tools_of(const ContactSetup<Dim>& s) {
  std::vector<std::shared_ptr<const Tool<Dim>>> tools;
  for (const auto& tool : s.tools()) tools.push_back(tool->shared_tool());
  return tools;
}
long dimension(H* const& h) {
  return guarded([&] { return static_cast<long>(h->get().dimension); });
}
long tool_number(H* const& h) {
  return on(h, [](auto& contact) { return static_cast<long>(contact.setup->tools().size()); });
}
string* coordinates(Stack stack, H* const& h) {
  return on(h, [&](auto& contact) {
    std::string text;
    for (const std::string& name : coordinate_names<dim_of<decltype(contact)>>(tools_of(*contact.setup)))
      text += (text.empty() ? "" : ",") + name;
    return new_string(stack, text);
  });
}
// f of every tool, one after another.
template <class F> KN_<double> all_tools(Stack stack, H* const& h, F f) {
  return on(h, [&](auto& contact) {
    std::vector<double> values;
    for (const auto& tool : contact.setup->tools())
      for (const double v : f(*tool)) values.push_back(v);
    return new_array(stack, values);
  });
}
KN_<double> all_q(Stack stack, H* const& h) {
  return all_tools(stack, h, [](auto& tool) { return tool.q(); });
}
KN_<double> all_forces(Stack stack, H* const& h) {
  return all_tools(stack, h, [](auto& tool) { return tool.generalized_force(); });
}
// Coordinate k of all tools: f(tool, its number there).
template <class Contact, class F> auto with_coordinate(Contact& contact, long k, const char* where, F f) {
  long n = 0;
  for (const auto& tool : contact.setup->tools()) {
    const long before = n;
    n += tool->prescription().size();
    if (k >= before && k < n) return f(*tool, static_cast<int>(k - before));
  }
  require(false, where, "coordinate", k, ("0 to " + std::to_string(n - 1)).c_str());
  return f(*contact.setup->tools()[0], 0);
}
struct DriveTag {};
string* drive(Stack stack, const Method<H, DriveTag>& m, const long& k) {
  static const char* const words[] = {"", "motion", "force", "follows"}; // in the order of Prescription::Kind
  return on(m.object, [&](auto& contact) {
    return with_coordinate(contact, k, "contact.drive", [&](auto& tool, int i) {
      return new_string(stack, words[static_cast<int>(tool.prescription().entries()[i].kind)]);
    });
  });
}
struct TwistTag {};
KN_<double> twist_of(Stack stack, const Method<H, TwistTag>& m, const long& k) {
  return on(m.object, [&](auto& contact) {
    return with_coordinate(contact, k, "contact.twist", [&](auto& tool, int i) {
      const Eigen::VectorXd values = twist(tool.tool().coordinates().pose(tool.q()), i);
      return new_array(stack, values.data(), static_cast<std::size_t>(values.size()));
    });
  });
}
KN_<double> node_tools(Stack stack, H* const& h) {
  return on(h, [&](auto& contact) {
    std::vector<double> values(contact.setup->candidates().size(), -1.);
    if (contact.started())
      for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = contact.run().accepted().contact.nodes[i].tool;
    return new_array(stack, values);
  });
}

struct NameTag {};
string* tool_name(Stack stack, const Method<H, NameTag>& m, const long& i) {
  return on(m.object, [&](auto& contact) {
    const auto& s = *contact.setup;
    return new_string(stack, s.tools()[tool_index(s, i, "contact.toolname")]->name());
  });
}
struct CountOfTag {};
long count_of(const Method<H, CountOfTag>& m, string* const& state, const long& i) {
  return on(m.object, [&](auto& contact) {
    const int tool = tool_index(*contact.setup, i, "contact.countof");
    const ContactState<dim_of<decltype(contact)>> none;
    return count_nodes(contact.started() ? contact.run().accepted().contact : none, *state, "contact.countof",
                       tool);
  });
}
template <int axis> struct ForceTag {};
template <int axis> double tool_force(const Method<H, ForceTag<axis>>& m, const long& i) {
  static constexpr const char* names[] = {"contact.toolforcex", "contact.toolforcey", "contact.toolforcez"};
  return on(m.object, [&](auto& contact) {
    constexpr int Dim = dim_of<decltype(contact)>;
    if (axis >= Dim) fail(names[axis], "z is in space, the contact is of the plane");
    const int tool = tool_index(*contact.setup, i, names[axis]);
    if (!contact.started()) return 0.;
    const auto& run = contact.run();
    return tool_resultant(run.setup().model(), run.accepted().contact, run.accepted().R,
                          tool)[std::min(axis, Dim - 1)];
  });
}
template <int axis> struct OutlineTag {};
std::vector<Vector<2>> outline_at(ContactOf<2>& contact, int tool, long n) {
  DrivenTool<2>& driven = *contact.setup->tools()[tool];
  const Eigen::VectorXd none;
  return n == 0 ? tool_outline(*contact.setup, contact.started() ? contact.run().accepted().u : none, tool)
                : outline(driven.tool(), driven.q(), n);
}
template <int axis>
KN_<double> outline_of(Stack stack, const Method<H, OutlineTag<axis>>& m, const long& i, const long& n) {
  return guarded([&] {
    auto& contact =
        of_dimension<2>(m->get(), "contact.outline",
                        "; a tool of space has no outline, its surface is in the files of the run");
    const int tool = tool_index(*contact.setup, i, "contact.outline");
    std::vector<double> values;
    for (const auto& x : called("contact.outline", [&] { return outline_at(contact, tool, n); }))
      values.push_back(x[axis]);
    return new_array(stack, values);
  });
}
struct ToolSurfaceTag {};
pmeshS surface_of(Stack stack, const Method<H, ToolSurfaceTag>& m, const long& i) {
  return guarded([&] {
    auto& contact = of_dimension<3>(m->get(), "contact.toolsurface",
                                    "; in the plane a tool has an outline, C.outlinex, C.outliney");
    const int tool = tool_index(*contact.setup, i, "contact.toolsurface");
    const Eigen::VectorXd none;
    return surface_mesh_of(
        stack, tool_surface(*contact.setup, contact.started() ? contact.run().accepted().u : none, tool));
  });
}
template <int axis> void register_outline(const char* name) {
  using M = Method<H, OutlineTag<axis>>;
  add_method<H, OutlineTag<axis>>(
      name, [] { return new OneOperator3s_<KN_<double>, M, long, long>(outline_of<axis>); });
}
template <int axis> void register_force(const char* name) {
  add_method<H, ForceTag<axis>>(
      name, [] { return new OneOperator2_<double, Method<H, ForceTag<axis>>, long>(tool_force<axis>); });
}

} // namespace

void register_contact_tools() {
  Add<H*>("dimension", ".", new OneOperator1_<long, H*>(dimension));
  Add<H*>("toolnumber", ".", new OneOperator1_<long, H*>(tool_number));
  Add<H*>("coordinates", ".", new OneOperator1s_<string*, H*>(coordinates));
  Add<H*>("q", ".", new OneOperator1s_<KN_<double>, H*>(all_q));
  Add<H*>("Q", ".", new OneOperator1s_<KN_<double>, H*>(all_forces));
  Add<H*>("nodetool", ".", new OneOperator1s_<KN_<double>, H*>(node_tools));
  add_method<H, NameTag>("toolname",
                         [] { return new OneOperator2s_<string*, Method<H, NameTag>, long>(tool_name); });
  add_method<H, DriveTag>("drive",
                          [] { return new OneOperator2s_<string*, Method<H, DriveTag>, long>(drive); });
  add_method<H, TwistTag>(
      "twist", [] { return new OneOperator2s_<KN_<double>, Method<H, TwistTag>, long>(twist_of); });
  add_method<H, CountOfTag>(
      "countof", [] { return new OneOperator3_<long, Method<H, CountOfTag>, string*, long>(count_of); });
  register_force<0>("toolforcex");
  register_force<1>("toolforcey");
  register_force<2>("toolforcez");
  register_outline<0>("outlinex");
  register_outline<1>("outliney");
  add_method<H, ToolSurfaceTag>(
      "toolsurface", [] { return new OneOperator2s_<pmeshS, Method<H, ToolSurfaceTag>, long>(surface_of); });
}

} // namespace burnish
