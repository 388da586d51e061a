#include "checks/contact_check.hpp"
#include <algorithm>
#include <sstream>

namespace burnish {
namespace {

// The largest violation among a tool's nodes in a step.
struct Violation {
  double value = 0;
  int node = -1;
  void take(double v, int i) {
    if (!(v > value)) return;
    value = v;
    node = i;
  }
};

template <int Dim>
void keep(const AcceptedStep<Dim>& step, const Violation& found, double bound, ViolationState& known) {
  if (found.value > bound && known.count++ == 0) known.first = step.t;
  if (!(found.value > known.value)) return;
  known.value = found.value;
  known.place = step.place_of(step.touching[found.node].x);
  known.t = step.t;
}

// Of the whole run, over the largest load of the tool.
void report(const std::string& tool, const char* check, const ViolationState& worst, double load,
            double bound, const std::string& what, CheckState& state, FindingList& findings) {
  const double value = worst.value / load;
  state.largest(check, value);
  findings.withdraw(check, tool);
  if (!(value > bound)) return;
  Finding* finding = findings.report(check, tool, Severity::UNTRUSTED, value, worst.t);
  finding->value = value;
  finding->bound = bound;
  finding->place = worst.place;
  finding->first = worst.first;
  finding->count = worst.count;
  std::ostringstream text;
  text << "tool \"" << tool << "\": " << what << value << " of its largest load, at "
       << place_text(worst.place) << ", t = " << worst.t;
  finding->text = text.str();
}

// Nodes next to one another that one tool touches.
struct Run {
  int nodes = 0, last = -1;
  double load = 0;
  std::vector<double> place;
};

template <int Dim> std::vector<Run> runs_of(const AcceptedStep<Dim>& step, int tool) {
  constexpr int jump = 2; // candidates further apart than this are not neighbors
  std::vector<Run> runs;
  for (const CheckedNode<Dim>& node : step.touching) {
    if (step.contact.nodes[node.candidate].tool != tool) continue;
    if (runs.empty() || node.candidate - runs.back().last > jump) runs.push_back({});
    Run& run = runs.back();
    ++run.nodes;
    run.last = node.candidate;
    run.load += node.force.F.norm();
    if (run.place.empty()) run.place = step.place_of(node.x);
  }
  return runs;
}

} // namespace

// Judged at the end: while a tool has hardly touched, what the residual leaves may be more than it carries.
template <int Dim>
void ContactCheck<Dim>::look_at_forces(const AcceptedStep<Dim>& step, const CheckOptions& options,
                                       CheckState& state, FindingList& findings) const {
  for (int tool = 0; tool < static_cast<int>(step.model.tools.size()); ++tool) {
    WidthState& known = state.width[tool];
    Violation tension, friction;
    double load = 0;
    for (int i = 0; i < static_cast<int>(step.touching.size()); ++i) {
      const CheckedNode<Dim>& node = step.touching[i];
      const ContactNode<Dim>& contact = step.contact.nodes[node.candidate];
      if (contact.tool != tool) continue;
      const SurfaceForce<Dim>& force = node.force.part;
      load += node.force.F.norm();
      tension.take(-force.N, i);
      if (contact.tied) continue; // its friction is part of that of its ends
      const DecidingForce<Dim>& at = node.deciding;
      friction.take(-step.model.law(node.candidate, tool).reserve(at.force, at.area), i);
      if (contact.state == NodeState::SLIDING) friction.take(node.at.m.dot(at.force.T), i);
    }
    known.load = std::max(known.load, load);
    if (tension.node >= 0) keep(step, tension, options.tension * load, known.tension);
    if (friction.node >= 0) keep(step, friction, options.friction_excess * load, known.friction);
    if (!step.last || !(known.load > 0)) continue;
    report(step.tool_name(tool), "tension", known.tension, known.load, options.tension,
           "it pulls at a node, by ", state, findings);
    report(step.tool_name(tool), "friction", known.friction, known.load, options.friction_excess,
           "friction beyond its limit, or along the slip, by ", state, findings);
  }
}

// Judged where the tool carries most, and at the end: a run may well begin with one node.
template <int Dim>
void ContactCheck<Dim>::look_at_width(const AcceptedStep<Dim>& step, const CheckOptions& options,
                                      CheckState& state, FindingList& findings) const {
  const int per_edge = step.mesh.nodes_per_element == Dim + 1 ? 1 : 2;
  const double few_nodes = per_edge * options.few_edges + 1;
  constexpr double carries = 0.1;    // a part of the contact that carries this part of the load counts
  constexpr double at_the_end = 0.5; // of the largest load: the last step counts too
  for (int tool = 0; tool < static_cast<int>(step.model.tools.size()); ++tool) {
    double load = 0;
    const std::vector<Run> runs = runs_of(step, tool);
    for (const Run& run : runs) load += run.load;
    if (runs.empty() || !(load > step.tolerance * step.load)) continue;
    WidthState& width = state.width[tool];
    const Run* few = nullptr;
    for (const Run& run : runs)
      if (run.load >= carries * load && (!few || run.nodes < few->nodes)) few = &run;
    if (!few) continue;
    ++width.steps;
    width.narrow += few->nodes <= few_nodes;
    if (load >= width.load || (step.last && load > at_the_end * width.load && few->nodes < width.nodes)) {
      width.nodes = few->nodes;
      width.place = few->place;
      width.t = step.t;
    }
    state.measured["contact nodes " + step.tool_name(tool)] = width.nodes;
    findings.withdraw("contact width", step.tool_name(tool));
    if (width.nodes > few_nodes) continue;
    Finding* finding = findings.report("contact width", step.tool_name(tool), Severity::WARNING, 0, width.t);
    finding->value = width.nodes;
    finding->bound = few_nodes;
    finding->place = width.place;
    finding->count = width.narrow;
    std::ostringstream text;
    text << "tool \"" << step.tool_name(tool) << "\" touches only " << width.nodes
         << (width.nodes == 1 ? " node" : " nodes in a row") << " where it carries most, at "
         << place_text(width.place) << ", t = " << width.t << ", and " << few_nodes << " or fewer in "
         << width.narrow << " of " << width.steps << " steps: refine the surface there";
    finding->text = text.str();
  }
}

template <int Dim>
void ContactCheck<Dim>::look(const AcceptedStep<Dim>& step, const CheckOptions& options, CheckState& state,
                             FindingList& findings) {
  state.width.resize(step.model.tools.size());
  look_at_forces(step, options, state, findings);
  look_at_width(step, options, state, findings);
}

template class ContactCheck<2>;
template class ContactCheck<3>;

} // namespace burnish
