// What a script reads of a contact, all of the accepted state. Arrays run over the candidates, the nodes of the surface that
// are not fixed, in order along it; nodal forces in the plane are per unit of thickness, axisymmetric of the whole ring.
//   C.nodes     numbers of the mesh nodes | -
//   C.x, C.y, C.z   present places; z in space | length
//   C.xref, C.yref, C.zref   places at the start; zref in space | length
//   C.state     0 free, 1 touched, 2 sliding, 3 sticking, 4 leaving, 5 receding | -
//   C.s         parameter on the tool: arc length, on a circle the angle | length, rad
//   C.gap       gap, positive = open | length
//   C.normalforce, C.tangentialforce   nodal forces of the tool on the body, pressing positive, along the tool's tangent; in space
//       its length | force
//   C.pressure, C.traction   the same as stresses, linear on every edge, of forces shared to the corners of P2 | stress
//   C.shearx, C.sheary, C.shearz   in space: the traction as a vector | stress
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
#include "base/error.hpp"
#include "contact/surface_report.hpp"
#include "contact/tool_report.hpp"
#include "named.hpp"
#include "types.hpp"

namespace burnish {
namespace {

using H = ContactHandle;
using Array = KN_<double>;

template <int Dim> SurfaceReport<Dim> report(const ContactOf<Dim>& contact) {
  const ContactRun<Dim>& run = contact.running("contact");
  const auto& state = run.accepted();
  return surface_report(run.setup().model(), run.setup().body(), state.contact, run.setup().surface(),
                        state.u, state.R);
}
// Column: a struct with `of`, a column of the report.
template <class Column> Array from_report(Stack stack, H* const& h) {
  return on(h, [&](auto& contact) { return new_array(stack, Column::of(report(contact))); });
}
// Along the tangent in the plane, the length in space.
template <class Column> Array along_tangent(Stack stack, H* const& h) {
  return on(h, [&](auto& contact) {
    const Eigen::MatrixXd t = Column::of(report(contact)); // a copy: the report ends here
    return new_array(stack, t.rows() == 1 ? Eigen::VectorXd(t.row(0)) : Eigen::VectorXd(t.colwise().norm()));
  });
}
struct Gap {
  template <class R> static const auto& of(const R& report) { return report.gap; }
};
struct Pressure {
  template <class R> static const auto& of(const R& report) { return report.pressure; }
};
struct NodalPressure {
  template <class R> static const auto& of(const R& report) { return report.nodal_pressure; }
};
struct NormalForce {
  template <class R> static const auto& of(const R& report) { return report.normal_force; }
};
struct Traction {
  template <class R> static const auto& of(const R& report) { return report.traction_tangential; }
};
struct NodalTraction {
  template <class R> static const auto& of(const R& report) { return report.nodal_traction; }
};
// x, y or z of the traction in space.
template <int axis> Array shear(Stack stack, H* const& h) {
  return guarded([&] {
    return new_array(stack, Eigen::VectorXd(report(of_dimension<3>(h->get(), "contact.shear",
                                                                   "; in the plane it is C.traction"))
                                                .traction_tangential.row(axis)));
  });
}
struct TangentialForce {
  template <class R> static const auto& of(const R& report) { return report.tangential_force; }
};
// One number per candidate.
template <class F> Array per_candidate(Stack stack, H* const& h, F value) {
  return on(h, [&](auto& contact) {
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
    constexpr int Dim = dim_of<decltype(contact)>;
    require_axis<Dim, axis>();
    const int dof = Dim * contact.setup->candidates()[i] + axis;
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
  return on(h, [](auto& contact) { return contact.started() ? burnish::contact_width(contact.run()) : 0.; });
}
double speed(H* const& h) {
  return on(h, [](auto& contact) { return contact.started() ? burnish::contact_speed(contact.run()) : 0.; });
}
double spacing(H* const& h) {
  return on(h, [](auto& contact) { return contact.run().setup().body().spacing; });
}
double residual(H* const& h) {
  return on(h, [](auto& contact) {
    return contact.started() ? contact.run().iteration().balance().last().residual : 0.;
  });
}
double load_scale(H* const& h) {
  return on(h, [](auto& contact) {
    return contact.started() ? contact.run().iteration().balance().memory().scale : 0.;
  });
}

struct CountTag {};
long count(const Method<H, CountTag>& m, string* const& state) {
  return on(m.object, [&](auto& contact) {
    const ContactState<dim_of<decltype(contact)>> none;
    return count_nodes(contact.started() ? contact.run().accepted().contact : none, *state, "contact.count");
  });
}

struct StatisticTag {};
long statistic(const Method<H, StatisticTag>& m, string* const& name) {
  return on(m.object, [&](auto& contact) {
    const IterationCounts counts = contact.started() ? contact.run().iteration().counts() : IterationCounts{};
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
  return on(m.object, [&](auto& contact) {
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

string* left_out(Stack stack, H* const& h) {
  return on(h, [&](auto& contact) {
    std::string text;
    if (!contact.started()) return new_string(stack, text);
    for (const auto& what : burnish::left_out(contact.run())) text += (text.empty() ? "" : "; ") + what;
    return new_string(stack, text);
  });
}

} // namespace

void register_contact_data() {
  const auto array = [](const char* name, Array (*f)(Stack, H* const&)) {
    Add<H*>(name, ".", new OneOperator1s_<Array, H*>(f));
  };
  array("nodes", nodes);
  array("x", place<0, false>);
  array("y", place<1, false>);
  array("z", place<2, false>);
  array("xref", place<0, true>);
  array("yref", place<1, true>);
  array("zref", place<2, true>);
  array("state", states);
  array("s", parameters);
  array("gap", from_report<Gap>);
  array("pressure", from_report<Pressure>);
  array("traction", along_tangent<Traction>);
  array("shearx", shear<0>);
  array("sheary", shear<1>);
  array("shearz", shear<2>);
  array("nodalpressure", from_report<NodalPressure>);
  array("nodaltraction", along_tangent<NodalTraction>);
  array("normalforce", from_report<NormalForce>);
  array("tangentialforce", along_tangent<TangentialForce>);
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
}

} // namespace burnish
