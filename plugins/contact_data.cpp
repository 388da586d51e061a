// What a script reads of a contact, all of the accepted state. Arrays run over the candidates, the nodes of the surface that
// are not fixed, in order along it; nodal forces in the plane are per unit of thickness, axisymmetric of the whole ring.
//   C.nodes     numbers of the mesh nodes | -
//   C.x, C.y    present places | length
//   C.xref, C.yref   places at the start | length
//   C.state     0 free, 1 touched, 2 sliding, 3 sticking, 4 leaving, 5 receding | -
//   C.s         parameter on the tool: arc length, on a circle the angle | length, rad
//   C.gap       gap, positive = open | length
//   C.normalforce, C.tangentialforce   nodal forces of the tool on the body, pressing positive, along the tool's tangent | force
//   C.pressure, C.traction   the same as stresses, linear on every edge, of forces shared to the corners of P2 | stress
//   C.nodalpressure, C.nodaltraction   nodal forces over tributary lengths: on P1 the same, on P2 they alternate between vertices and mid
//       nodes | stress
//   C.width     contact width, of several tools the largest | length
//   C.speed     speed of the contact along the body in the last step | length/time
//   C.spacing   median distance of neighboring candidates | length
//   C.residual   largest force out of balance, nodes and coordinates under force, last iteration | force
//   C.loadscale   load that the tolerance refers to: largest contact resultant of the run so far | force
//   C.count(state)   number of nodes in a state | -
//     state     "free", "touched", "sliding", "sticking", "leaving", "receding", or "contact": touched, sliding or sticking
//     ! , expected free, touched, sliding, sticking, leaving, receding or contact
//   C.leftout   what the run took no account of, as a text
//   C.statistic(name)   counts of the run | -
//     name      "iterations", "factorizations", "solves", "analyses", "backtracks", "condensations"; "factorentries": numbers stored in the
//       last factor of the core
//     ! , expected iterations, factorizations, solves, analyses, backtracks, condensations or factorentries
//   C.seconds(phase)   CPU time | s
//     phase     "condensation", "factorization", "solve", "events", "checks"
//     ! , expected condensation, factorization, solve, events or checks
//   C.eventnumber   length of the event log, a table i = 0 .. C.eventnumber-1 | -
//   C.eventtime(i)   instant | time
//     i         line of the log | - | | 0 to eventnumber-1
//   C.eventkind(i)   kind, see events.csv; of a user-defined one its name
//     i         line of the log | - | | 0 to eventnumber-1
//   C.eventnode(i)   node, of an event at a point the quadrature point | -
//     i         line of the log | - | | 0 to eventnumber-1
//   C.eventtool(i)   name of the tool, "" at a point
//     i         line of the log | - | | 0 to eventnumber-1
//   C.eventx(i), C.eventy(i)   place | length
//     i         line of the log | - | | 0 to eventnumber-1
#include "base/error.hpp"
#include "contact/surface_report.hpp"
#include "contact/tool_report.hpp"
#include "named.hpp"
#include "types.hpp"

namespace burnish {
namespace {

using H = ContactHandle;
using Array = KN_<double>;

SurfaceReport<2> report(const ContactRun<2>& run) {
  const auto& state = run.accepted();
  return surface_report(run.setup().model(), run.setup().body(), state.contact, run.setup().surface(),
                        state.u, state.R);
}
template <Eigen::VectorXd SurfaceReport<2>::*member> Array from_report(Stack stack, H* const& h) {
  return guarded([&] { return new_array(stack, report(h->get().running("contact")).*member); });
}
template <Eigen::MatrixXd SurfaceReport<2>::*member> Array along_tangent(Stack stack, H* const& h) {
  return guarded([&] {
    return new_array(stack, Eigen::VectorXd((report(h->get().running("contact")).*member).row(0)));
  });
}
// One number per candidate.
template <class F> Array per_candidate(Stack stack, H* const& h, F value) {
  return guarded([&] {
    ContactObject& contact = h->get();
    std::vector<double> v;
    for (std::size_t i = 0; i < contact.setup->candidates().size(); ++i) v.push_back(value(contact, i));
    return new_array(stack, v);
  });
}
Array nodes(Stack stack, H* const& h) {
  return per_candidate(stack, h, [](const auto& contact, std::size_t i) {
    return static_cast<double>(contact.setup->candidates()[i]);
  });
}
template <int axis, bool reference> Array place(Stack stack, H* const& h) {
  return per_candidate(stack, h, [](auto& contact, std::size_t i) {
    const int dof = 2 * contact.setup->candidates()[i] + axis;
    const double moved = reference || !contact.started() ? 0 : contact.run().accepted().u[dof];
    return contact.setup->mesh().X[dof] + moved;
  });
}
Array states(Stack stack, H* const& h) {
  return per_candidate(stack, h, [](auto& contact, std::size_t i) {
    return contact.started() ? static_cast<double>(contact.run().accepted().contact.nodes[i].state) : 0.;
  });
}
Array parameters(Stack stack, H* const& h) {
  return per_candidate(stack, h, [](auto& contact, std::size_t i) {
    return contact.started() ? contact.run().accepted().contact.nodes[i].place.hint[0] : 0.;
  });
}
double width(H* const& h) {
  return guarded([&] { return h->get().started() ? burnish::contact_width(h->get().run()) : 0.; });
}
double speed(H* const& h) {
  return guarded([&] { return h->get().started() ? burnish::contact_speed(h->get().run()) : 0.; });
}
double spacing(H* const& h) {
  return guarded([&] { return h->get().run().setup().body().spacing; });
}
double residual(H* const& h) {
  return guarded(
      [&] { return h->get().started() ? h->get().run().iteration().balance().last().residual : 0.; });
}
double load_scale(H* const& h) {
  return guarded(
      [&] { return h->get().started() ? h->get().run().iteration().balance().memory().scale : 0.; });
}

struct CountTag {};
long count(const Method<H, CountTag>& m, string* const& state) {
  return guarded([&] {
    const ContactState<2> none;
    return count_nodes(m->get().started() ? m->get().run().accepted().contact : none, *state,
                       "contact.count");
  });
}

struct StatisticTag {};
long statistic(const Method<H, StatisticTag>& m, string* const& name) {
  return guarded([&] {
    const IterationCounts counts =
        m->get().started() ? m->get().run().iteration().counts() : IterationCounts{};
    if (*name == "iterations") return counts.iterations;
    if (*name == "factorizations") return counts.factorizations;
    if (*name == "solves") return counts.solves;
    if (*name == "analyses") return counts.analyses;
    if (*name == "backtracks") return counts.backtracks;
    if (*name == "condensations") return counts.condensations;
    if (*name == "factorentries") return counts.factor_entries;
    fail("contact.statistic", "unknown name \"" + *name +
                                  "\", expected iterations, factorizations, solves, analyses, backtracks, "
                                  "condensations or factorentries");
  });
}

struct SecondsTag {};
double seconds(const Method<H, SecondsTag>& m, string* const& phase) {
  return guarded([&] {
    ContactObject& contact = m->get();
    const auto counts = contact.started() ? contact.run().iteration().counts() : IterationCounts{};
    if (*phase == "condensation") return counts.condensation_seconds + contact.condense_seconds;
    if (*phase == "factorization") return counts.factorization_seconds;
    if (*phase == "solve") return counts.solve_seconds;
    if (*phase == "events") return contact.event_seconds;
    if (*phase == "checks") return contact.diagnosis.seconds();
    fail("contact.seconds",
         "unknown phase \"" + *phase + "\", expected condensation, factorization, solve, events or checks");
  });
}

const std::vector<ContactEvent<2>>& log_of(ContactObject& contact) {
  static const std::vector<ContactEvent<2>> none;
  return contact.started() ? contact.run().accepted().log.events : none;
}
const ContactEvent<2>& event(H* h, long i) {
  const auto& log = log_of(h->get());
  require(i >= 0 && i < static_cast<long>(log.size()), "contact.event", "index", i, "less than eventnumber");
  return log[static_cast<std::size_t>(i)];
}
struct TimeTag {};
struct KindTag {};
struct NodeTag {};
struct ToolTag {};
struct XTag {};
struct YTag {};
double event_time(const Method<H, TimeTag>& m, const long& i) {
  return guarded([&] { return event(m.object, i).t; });
}
string* event_kind(Stack stack, const Method<H, KindTag>& m, const long& i) {
  return guarded([&] { return new_string(stack, kind_of(event(m.object, i))); });
}
long event_node(const Method<H, NodeTag>& m, const long& i) {
  return guarded([&] { return static_cast<long>(event(m.object, i).node); });
}
string* event_tool(Stack stack, const Method<H, ToolTag>& m, const long& i) {
  return guarded([&] {
    const int t = event(m.object, i).tool;
    return new_string(stack, t < 0 ? "" : m->get().setup->tools()[t]->name());
  });
}
double event_x(const Method<H, XTag>& m, const long& i) {
  return guarded([&] { return event(m.object, i).x[0]; });
}
double event_y(const Method<H, YTag>& m, const long& i) {
  return guarded([&] { return event(m.object, i).x[1]; });
}
long event_number(H* const& h) {
  return guarded([&] { return static_cast<long>(log_of(h->get()).size()); });
}
string* left_out(Stack stack, H* const& h) {
  return guarded([&] {
    std::string text;
    if (!h->get().started()) return new_string(stack, text);
    for (const auto& what : burnish::left_out(h->get().run())) text += (text.empty() ? "" : "; ") + what;
    return new_string(stack, text);
  });
}

void register_event_table() {
  Add<H*>("eventnumber", ".", new OneOperator1_<long, H*>(event_number));
  add_method<H, TimeTag>("eventtime",
                         [] { return new OneOperator2_<double, Method<H, TimeTag>, long>(event_time); });
  add_method<H, KindTag>("eventkind",
                         [] { return new OneOperator2s_<string*, Method<H, KindTag>, long>(event_kind); });
  add_method<H, NodeTag>("eventnode",
                         [] { return new OneOperator2_<long, Method<H, NodeTag>, long>(event_node); });
  add_method<H, ToolTag>("eventtool",
                         [] { return new OneOperator2s_<string*, Method<H, ToolTag>, long>(event_tool); });
  add_method<H, XTag>("eventx", [] { return new OneOperator2_<double, Method<H, XTag>, long>(event_x); });
  add_method<H, YTag>("eventy", [] { return new OneOperator2_<double, Method<H, YTag>, long>(event_y); });
}

} // namespace

void register_contact_data() {
  using Report = SurfaceReport<2>;
  const auto array = [](const char* name, Array (*f)(Stack, H* const&)) {
    Add<H*>(name, ".", new OneOperator1s_<Array, H*>(f));
  };
  array("nodes", nodes);
  array("x", place<0, false>);
  array("y", place<1, false>);
  array("xref", place<0, true>);
  array("yref", place<1, true>);
  array("state", states);
  array("s", parameters);
  array("gap", from_report<&Report::gap>);
  array("pressure", from_report<&Report::pressure>);
  array("traction", along_tangent<&Report::traction_tangential>);
  array("nodalpressure", from_report<&Report::nodal_pressure>);
  array("nodaltraction", along_tangent<&Report::nodal_traction>);
  array("normalforce", from_report<&Report::normal_force>);
  array("tangentialforce", along_tangent<&Report::tangential_force>);
  const auto number = [](const char* name, double (*f)(H* const&)) {
    Add<H*>(name, ".", new OneOperator1_<double, H*>(f));
  };
  number("width", width);
  number("speed", speed);
  number("spacing", spacing);
  number("residual", residual);
  number("loadscale", load_scale);
  add_method<H, CountTag>("count",
                          [] { return new OneOperator2_<long, Method<H, CountTag>, string*>(count); });
  add_method<H, StatisticTag>(
      "statistic", [] { return new OneOperator2_<long, Method<H, StatisticTag>, string*>(statistic); });
  add_method<H, SecondsTag>(
      "seconds", [] { return new OneOperator2_<double, Method<H, SecondsTag>, string*>(seconds); });
  Add<H*>("leftout", ".", new OneOperator1s_<string*, H*>(left_out));
  register_event_table();
}

} // namespace burnish
