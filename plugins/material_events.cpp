// User-defined events at the points of a material: found, logged, counted; what they may do: material_damage.cpp.
//   M.parameter(name, value)   a number by name for the formulas of later calls of event; returns it | its own
//     name      name in the formula
//     value     the number | its own | | finite
//   M.event(name, formula)   defines an event: it happens at a point where the formula passes through zero from < 0 to >= 0
//     name      its name in the log | | | no comma, quote, line break; not a kind of events.csv
//     formula   of ep plastic strain, seq von Mises, sm mean stress, sxx syy szz sxy, s1 s3 largest and smallest principal
//       stress, x y place
//     > M.event("damage", "ep - 0.1*exp(-1.5*sm/seq)");
//     ! is that of a built-in kind of event
//     ! is taken
//   M.eventpoints(name)   how often it has happened, per quadrature point | -
//     name      of the event
//     ! no event
//   M.eventnumber(name)   how often in all | -
//     name      of the event
//   C.logpoints(M)   before M.accept: all of this step to the contact's log; returns how many | -
//     M         the material
//   M.pointevents(tolerance, least)   fraction of the step of the earliest one beyond least, 2: none; until accept or revert
//       those within the tolerance after the end count as at the end | -
//     tolerance   fraction of the step | - | | >= 0
//     least     fraction of the step | -
#include "base/error.hpp"
#include "types.hpp"

namespace burnish {
namespace {

using M = MaterialHandle;
struct MaterialParameterTag {};
struct EventTag {};
struct PointsTag {};
struct NumberTag {};
struct EarliestTag {};
struct LogTag {};

double parameter(const Method<M, MaterialParameterTag>& m, string* const& name, const double& value) {
  return on(m.object, [&](auto& material) {
    const PointVariables<dim_of<decltype(material)>> variables(material.workpiece().law());
    check_formula_names("material.parameter", {variables.names(), {{*name, value}}});
    return material.parameters[*name] = value;
  });
}
bool event(const Method<M, EventTag>& m, string* const& name, string* const& formula) {
  return on(m.object, [&](auto& object) {
    for (char kind = 0; kind <= static_cast<char>(EventKind::USER); ++kind)
      if (*name == name_of(static_cast<EventKind>(kind)))
        fail("material.event", "name \"" + *name + "\" is that of a built-in kind of event");
    const int true_now = called("material.event", [&] {
      return object.body->user().add(object.workpiece(), *name, *formula, object.parameters);
    });
    if (true_now > 0)
      cout << "burnish: warning: event \"" << *name << "\": its formula is >= 0 at " << true_now << " of "
           << object.workpiece().discretization().num_points()
           << " points already: it happens there only after it has been below" << endl;
    return true;
  });
}
KN_<double> points(Stack stack, const Method<M, PointsTag>& m, string* const& name) {
  return on(m.object, [&](auto& material) {
    const auto counts = called("material.eventpoints", [&] { return material.body->user().counts(*name); });
    return new_array(stack, std::vector<double>(counts.begin(), counts.end()));
  });
}
long number(const Method<M, NumberTag>& m, string* const& name) {
  return on(m.object, [&](auto& material) -> long {
    return called("material.eventnumber", [&] { return material.body->user().number(*name); });
  });
}
double earliest(const Method<M, EarliestTag>& m, const double& tolerance, const double& least) {
  return on(m.object, [&](auto& material) {
    return called("material.pointevents",
                  [&] { return material.body->find_earliest_user(tolerance, least); });
  });
}
long log_points(const Method<ContactHandle, LogTag>& c, M* const& material) {
  return on(c.object, [&](auto& contact) {
    contact.run().step().require_begun("contact.logpoints");
    const CpuTimer timer(contact.event_seconds);
    const auto events = contact.with_material(material->get(), "contact.logpoints").body->user_events();
    contact.run().log_elements(events);
    return static_cast<long>(events.size());
  });
}

} // namespace

void register_point_events() {
  add_method<M, MaterialParameterTag>("parameter", [] {
    return new OneOperator3_<double, Method<M, MaterialParameterTag>, string*, double>(parameter);
  });
  add_method<M, EventTag>(
      "event", [] { return new OneOperator3_<bool, Method<M, EventTag>, string*, string*>(event); });
  add_method<M, PointsTag>(
      "eventpoints", [] { return new OneOperator2s_<KN_<double>, Method<M, PointsTag>, string*>(points); });
  add_method<M, NumberTag>("eventnumber",
                           [] { return new OneOperator2_<long, Method<M, NumberTag>, string*>(number); });
  add_method<M, EarliestTag>("pointevents", [] {
    return new OneOperator3_<double, Method<M, EarliestTag>, double, double>(earliest);
  });
  add_method<ContactHandle, LogTag>(
      "logpoints", [] { return new OneOperator2_<long, Method<ContactHandle, LogTag>, M*>(log_points); });
}

} // namespace burnish
