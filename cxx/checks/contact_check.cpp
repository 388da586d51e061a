#include "checks/contact_check.hpp"
#include <algorithm>
#include <sstream>

namespace burnish {
namespace {

// The worst violation of a tool's nodes, over its own load.
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
void report(const AcceptedStep<Dim>& step, const char* check, int tool, const Violation& worst, double bound,
            const std::string& what, CheckState& state, FindingList& findings) {
  state.largest(check, worst.value);
  if (!(worst.value > bound)) return;
  Finding* finding = findings.report(check, step.tool_name(tool), Severity::UNTRUSTED, worst.value, step.t);
  if (!finding) return;
  const Vector<Dim>& x = step.touching[worst.node].x;
  finding->value = worst.value;
  finding->bound = bound;
  finding->place = step.place_of(x);
  std::ostringstream text;
  text << "tool \"" << step.tool_name(tool) << "\": " << what << worst.value << step.at(x);
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

template <int Dim>
void ContactCheck<Dim>::look_at_forces(const AcceptedStep<Dim>& step, const CheckOptions& options,
                                       CheckState& state, FindingList& findings) const {
  for (int tool = 0; tool < static_cast<int>(step.model.tools.size()); ++tool) {
    double load = 0;
    Violation tension, friction, back;
    for (const auto& node : step.touching)
      if (step.contact.nodes[node.candidate].tool == tool) load += node.force.F.norm();
    // what the residual leaves of the whole load is no load of this tool
    load = std::max(load, step.tolerance * step.load);
    if (!(load > 0)) continue;
    for (int i = 0; i < static_cast<int>(step.touching.size()); ++i) {
      const CheckedNode<Dim>& node = step.touching[i];
      const ContactNode<Dim>& contact = step.contact.nodes[node.candidate];
      if (contact.tool != tool) continue;
      const TangentialLaw<Dim>& law = step.model.law(node.candidate, tool);
      const SurfaceForce<Dim>& force = node.force.part;
      tension.take(-force.N / load, i);
      friction.take(-law.reserve(force, contact.tributary_area) / load, i);
      if (contact.state != NodeState::SLIDING) continue;
      friction.take(node.at.m.dot(force.T) / load, i);
      back.take(-slip_of(step.model, contact).dot(node.at.m) / step.body.spacing, i);
    }
    report(step, "tension", tool, tension, options.tension,
           "it pulls at a node, by this part of its load: ", state, findings);
    report(step, "friction", tool, friction, options.friction_excess,
           "friction beyond its limit, or along the slip, by this part of its load: ", state, findings);
    report(step, "slip", tool, back, options.slip_back,
           "a node slips along its friction force, by this part of the spacing: ", state, findings);
  }
}

// Judged where the tool carries most, and at the end: a run may well begin with one node.
template <int Dim>
void ContactCheck<Dim>::look_at_width(const AcceptedStep<Dim>& step, const CheckOptions& options,
                                      CheckState& state, FindingList& findings) const {
  constexpr double carries = 0.1;    // a part of the contact that carries this part of the load counts
  constexpr double at_the_end = 0.5; // of the largest load: the last step counts too
  state.width.resize(step.model.tools.size());
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
    width.narrow += few->nodes <= options.few_nodes;
    if (load > width.load || (step.last && load > at_the_end * width.load && few->nodes < width.nodes)) {
      width.nodes = few->nodes;
      width.place = few->place;
      width.t = step.t;
    }
    width.load = std::max(width.load, load);
    state.measured["contact nodes " + step.tool_name(tool)] = width.nodes;
    findings.withdraw("contact width", step.tool_name(tool));
    if (width.nodes > options.few_nodes) continue;
    Finding* finding = findings.report("contact width", step.tool_name(tool), Severity::WARNING, 0, width.t);
    finding->value = width.nodes;
    finding->bound = options.few_nodes;
    finding->place = width.place;
    finding->count = width.narrow;
    std::ostringstream text;
    text << "the contact of tool \"" << step.tool_name(tool) << "\" is " << width.nodes
         << (width.nodes == 1 ? " node" : " nodes") << " wide where it carries most, at "
         << place_text(width.place) << ", t = " << width.t << ", and " << options.few_nodes << " or fewer in "
         << width.narrow << " of " << width.steps << " steps: refine the contact surface";
    finding->text = text.str();
  }
}

template <int Dim>
void ContactCheck<Dim>::look(const AcceptedStep<Dim>& step, const CheckOptions& options, CheckState& state,
                             FindingList& findings) {
  look_at_forces(step, options, state, findings);
  look_at_width(step, options, state, findings);
}

template class ContactCheck<2>;
template class ContactCheck<3>;

} // namespace burnish
