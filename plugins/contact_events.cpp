// The event log of a contact, all of the run so far.
//   C.eventnumber   length of the event log, a table i = 0 .. C.eventnumber-1 | -
//   C.eventtime(i)   instant | time
//     i         line of the log | - | | 0 to eventnumber-1
//   C.eventkind(i)   kind, see events.csv; of a user-defined one its name
//     i         line of the log | - | | 0 to eventnumber-1
//   C.eventnode(i)   node, of an event at a point the quadrature point | -
//     i         line of the log | - | | 0 to eventnumber-1
//   C.eventtool(i)   name of the tool, "" at a point
//     i         line of the log | - | | 0 to eventnumber-1
//   C.eventx(i), C.eventy(i), C.eventz(i)   place; z in space | length
//     i         line of the log | - | | 0 to eventnumber-1
#include "base/error.hpp"
#include "named.hpp"
#include "types.hpp"

namespace burnish {
namespace {

using H = ContactHandle;

template <int Dim> const std::vector<ContactEvent<Dim>>& log_of(ContactOf<Dim>& contact) {
  static const std::vector<ContactEvent<Dim>> none;
  return contact.started() ? contact.run().accepted().log.events : none;
}
// f of line i of the log, and of the contact.
template <class F> auto of_event(H* h, long i, F&& f) {
  return on(h, [&](auto& contact) {
    const auto& log = log_of(contact);
    require(i >= 0 && i < static_cast<long>(log.size()), "contact.event", "index", i,
            "less than eventnumber");
    return f(log[static_cast<std::size_t>(i)], contact);
  });
}
struct TimeTag {};
struct KindTag {};
struct NodeTag {};
struct ToolTag {};
template <int axis> struct PlaceTag {};
double event_time(const Method<H, TimeTag>& m, const long& i) {
  return of_event(m.object, i, [](const auto& event, auto&) { return event.t; });
}
string* event_kind(Stack stack, const Method<H, KindTag>& m, const long& i) {
  return of_event(m.object, i, [&](const auto& event, auto&) { return new_string(stack, kind_of(event)); });
}
long event_node(const Method<H, NodeTag>& m, const long& i) {
  return of_event(m.object, i, [](const auto& event, auto&) { return static_cast<long>(event.node); });
}
string* event_tool(Stack stack, const Method<H, ToolTag>& m, const long& i) {
  return of_event(m.object, i, [&](const auto& event, auto& contact) {
    return new_string(stack, event.tool < 0 ? "" : contact.setup->tools()[event.tool]->name());
  });
}
template <int axis> double event_place(const Method<H, PlaceTag<axis>>& m, const long& i) {
  return of_event(m.object, i, [](const auto& event, auto& contact) {
    constexpr int Dim = dim_of<decltype(contact)>;
    require_axis<Dim, axis>();
    return event.x[std::min(axis, Dim - 1)];
  });
}
long event_number(H* const& h) {
  return on(h, [](auto& contact) { return static_cast<long>(log_of(contact).size()); });
}

template <int axis> void add_event_place(const char* name) {
  add_method<H, PlaceTag<axis>>(
      name, [] { return new OneOperator2_<double, Method<H, PlaceTag<axis>>, long>(event_place<axis>); });
}
} // namespace

void register_contact_events() {
  Add<H*>("eventnumber", ".", new OneOperator1_<long, H*>(event_number));
  add_method<H, TimeTag>("eventtime",
                         [] { return new OneOperator2_<double, Method<H, TimeTag>, long>(event_time); });
  add_method<H, KindTag>("eventkind",
                         [] { return new OneOperator2s_<string*, Method<H, KindTag>, long>(event_kind); });
  add_method<H, NodeTag>("eventnode",
                         [] { return new OneOperator2_<long, Method<H, NodeTag>, long>(event_node); });
  add_method<H, ToolTag>("eventtool",
                         [] { return new OneOperator2s_<string*, Method<H, ToolTag>, long>(event_tool); });
  add_event_place<0>("eventx");
  add_event_place<1>("eventy");
  add_event_place<2>("eventz");
}

} // namespace burnish
