// What a script reads of the tools of a contact, i = 0 .. C.toolnumber-1 in the order of C.add, accepted state.
//   C.toolnumber   how many | -
//   C.toolname(i)   name of tool i
//     i         tool | - | | 0 to toolnumber-1
//   C.coordinates   names "x,y,angle"; with several tools "upper.x,upper.y,...,lower.x,..."
//   C.q         coordinates in that order | length, rad
//   C.Q         generalized forces on them | force, force*length
//   C.countof(state, i)   number of nodes of tool i in a state | -
//     state     as in C.count
//     i         tool | - | | 0 to toolnumber-1
//   C.toolforcex(i), C.toolforcey(i)   resultant of the contact forces on tool i | force
//     i         tool | - | | 0 to toolnumber-1
//   C.outlinex(i, n), C.outliney(i, n)   outline of tool i: n points and its joints; n = 0: as many as a picture of the
//       workpiece needs, more where it bends and is seen | length
//     i         tool | - | | 0 to toolnumber-1
//     n         number of points | - | | 0, 2 to 1000000
//   C.nodetool   over the candidates: tool in contact, or the last one; -1 none | -
#include "base/error.hpp"
#include "contact/tool_report.hpp"
#include "kinematics/outline.hpp"
#include "named.hpp"
#include "output/contact_files.hpp"
#include "types.hpp"

namespace burnish {
namespace {

using H = ContactHandle;

int tool_index(const ContactSetup<2>& s, long i, const char* where) {
  const long n = static_cast<long>(s.tools().size());
  require(i >= 0 && i < n, where, "tool", i, ("0 to toolnumber-1 = " + std::to_string(n - 1)).c_str());
  return static_cast<int>(i);
}
std::vector<std::shared_ptr<const Tool<2>>> tools_of(const ContactSetup<2>& s) {
  std::vector<std::shared_ptr<const Tool<2>>> tools;
  for (const auto& tool : s.tools()) tools.push_back(tool->shared_tool());
  return tools;
}
long tool_number(H* const& h) {
  return guarded([&] { return static_cast<long>(h->get().setup->tools().size()); });
}
string* coordinates(Stack stack, H* const& h) {
  return guarded([&] {
    std::string text;
    for (const std::string& name : coordinate_names<2>(tools_of(*h->get().setup)))
      text += (text.empty() ? "" : ",") + name;
    return new_string(stack, text);
  });
}
template <Eigen::VectorXd& (DrivenTool<2>::*member)()> KN_<double> all_tools(Stack stack, H* const& h) {
  return guarded([&] {
    std::vector<double> values;
    for (const auto& tool : h->get().setup->tools())
      for (const double v : (tool.get()->*member)()) values.push_back(v);
    return new_array(stack, values);
  });
}
KN_<double> node_tools(Stack stack, H* const& h) {
  return guarded([&] {
    std::vector<double> values(h->get().setup->candidates().size(), -1.);
    if (h->get().started())
      for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = h->get().run().accepted().contact.nodes[i].tool;
    return new_array(stack, values);
  });
}

struct NameTag {};
string* tool_name(Stack stack, const Method<H, NameTag>& m, const long& i) {
  return guarded([&] {
    const ContactSetup<2>& s = *m->get().setup;
    return new_string(stack, s.tools()[tool_index(s, i, "contact.toolname")]->name());
  });
}
struct CountOfTag {};
long count_of(const Method<H, CountOfTag>& m, string* const& state, const long& i) {
  return guarded([&] {
    const int tool = tool_index(*m->get().setup, i, "contact.countof");
    const ContactState<2> none;
    return count_nodes(m->get().started() ? m->get().run().accepted().contact : none, *state,
                       "contact.countof", tool);
  });
}
template <int axis> struct ForceTag {};
template <int axis> double tool_force(const Method<H, ForceTag<axis>>& m, const long& i) {
  return guarded([&] {
    const int tool = tool_index(*m->get().setup, i, axis == 0 ? "contact.toolforcex" : "contact.toolforcey");
    if (!m->get().started()) return 0.;
    const ContactRun<2>& run = m->get().run();
    return tool_resultant(run.setup().model(), run.accepted().contact, run.accepted().R, tool)[axis];
  });
}
template <int axis> struct OutlineTag {};
template <int axis>
KN_<double> outline_of(Stack stack, const Method<H, OutlineTag<axis>>& m, const long& i, const long& n) {
  return guarded([&] {
    ContactObject& contact = m->get();
    const int tool = tool_index(*contact.setup, i, "contact.outline");
    DrivenTool<2>& driven = *contact.setup->tools()[tool];
    const Eigen::VectorXd none;
    const auto points = called("contact.outline", [&] {
      return n == 0
                 ? tool_outline(*contact.setup, contact.started() ? contact.run().accepted().u : none, tool)
                 : outline(driven.tool(), driven.q(), n);
    });
    std::vector<double> values;
    for (const auto& x : points) values.push_back(x[axis]);
    return new_array(stack, values);
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
  Add<H*>("toolnumber", ".", new OneOperator1_<long, H*>(tool_number));
  Add<H*>("coordinates", ".", new OneOperator1s_<string*, H*>(coordinates));
  Add<H*>("q", ".", new OneOperator1s_<KN_<double>, H*>(all_tools<&DrivenTool<2>::q>));
  Add<H*>("Q", ".", new OneOperator1s_<KN_<double>, H*>(all_tools<&DrivenTool<2>::generalized_force>));
  Add<H*>("nodetool", ".", new OneOperator1s_<KN_<double>, H*>(node_tools));
  add_method<H, NameTag>("toolname",
                         [] { return new OneOperator2s_<string*, Method<H, NameTag>, long>(tool_name); });
  add_method<H, CountOfTag>(
      "countof", [] { return new OneOperator3_<long, Method<H, CountOfTag>, string*, long>(count_of); });
  register_force<0>("toolforcex");
  register_force<1>("toolforcey");
  register_outline<0>("outlinex");
  register_outline<1>("outliney");
}

} // namespace burnish
