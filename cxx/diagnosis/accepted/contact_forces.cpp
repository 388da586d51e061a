// What a contact must fulfill: no tension, friction within its limit and against the slip (ALGORITHMS.md 16.2).
#include "base/sentence.hpp"
#include "diagnosis/accepted/no_load.hpp"
#include "diagnosis/observers.hpp"
#include <algorithm>

namespace burnish {
namespace {

struct Condition {
  const char* check;
  double bound; // of a violation over the largest load of the tool: beyond it untrusted
  const char* words;
};
constexpr Condition TENSION{"tension", 0.02, "it pulls at a node, by "},
    FRICTION{"friction", 0.02, "friction beyond its limit, or along the slip, by "};

// A force or a slip that contradicts the contact, the largest of the run.
struct ViolationState {
  double value = 0; // [force, length]
  std::vector<double> place;
  double t = 0, first = 0;
  long count = 0; // steps beyond the bound, over the load of then
  BURNISH_FIELDS(value, place, t, first, count)
};

struct ToolForces {
  double load = 0; // largest of the run [force]
  ViolationState tension, friction;
  BURNISH_FIELDS(load, tension, friction)
};

template <int Dim> class ContactForcesCheck final : public ObserverOf<ContactForcesCheck<Dim>, Dim> {
public:
  BURNISH_REMEMBERS(m_tools)
  void look(const AcceptedStep<Dim>& step, FindingList& findings) override;

private:
  std::vector<ToolForces> m_tools;
};

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
void report(const std::string& tool, const Condition& condition, const ViolationState& worst, double load,
            FindingList& findings) {
  const double value = worst.value / load;
  findings.largest(condition.check, value);
  findings.withdraw(condition.check, tool);
  if (!(value > condition.bound)) return;
  Finding* finding = findings.report(condition.check, tool, Severity::UNTRUSTED, value, worst.t);
  finding->value = value;
  finding->bound = condition.bound;
  finding->place = worst.place;
  finding->first = worst.first;
  finding->count = worst.count;
  finding->text = sentence("tool \"", tool, "\": ", condition.words, value, " of its largest load, at ",
                           place_text(worst.place), ", t = ", worst.t);
}

// Judged at the end: while a tool has hardly touched, what the residual leaves may be more than it carries.
template <int Dim> void ContactForcesCheck<Dim>::look(const AcceptedStep<Dim>& step, FindingList& findings) {
  m_tools.resize(step.model().tools.size());
  for (int tool = 0; tool < static_cast<int>(step.model().tools.size()); ++tool) {
    ToolForces& known = m_tools[tool];
    Violation tension, friction;
    double load = 0;
    for (int i = 0; i < static_cast<int>(step.touching.size()); ++i) {
      const CheckedNode<Dim>& node = step.touching[i];
      const ContactNode<Dim>& contact = step.contact.nodes[node.candidate];
      if (contact.tool != tool) continue;
      const SurfaceForce<Dim>& force = node.force.part;
      load += node.force.F.norm();
      tension.take(step.model().is_weightless(node.candidate) ? -node.deciding.normal : -force.N, i);
      if (contact.tied) continue; // its friction is part of that of its ends
      const DecidingForce<Dim>& at = node.deciding;
      friction.take(-step.model().law(node.candidate, contact).reserve(at), i);
      if (contact.state == NodeState::SLIDING) friction.take(node.at.m.dot(at.force.T), i);
    }
    known.load = std::max(known.load, load);
    if (tension.node >= 0) keep(step, tension, TENSION.bound * load, known.tension);
    if (friction.node >= 0) keep(step, friction, FRICTION.bound * load, known.friction);
    if (!step.last || is_no_load(step, known.load)) continue;
    report(step.tool_name(tool), TENSION, known.tension, known.load, findings);
    report(step.tool_name(tool), FRICTION, known.friction, known.load, findings);
  }
}

} // namespace

BURNISH_OBSERVER(contact_forces_check, ContactForcesCheck)

} // namespace burnish
