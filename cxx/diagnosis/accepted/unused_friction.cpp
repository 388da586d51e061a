// Friction far from its limit (ALGORITHMS.md 17.1).
#include "diagnosis/observers.hpp"

namespace burnish {
namespace {

constexpr double USED = 0.25; // friction over its limit: below, the limit is of no influence
constexpr double LOADED =
    1e-2; // a node carries load if its normal force is this part of the tool's largest one

// How much of a tool's friction was ever needed.
struct FrictionUse {
  double largest = 0;          // |T| over its limit, of the nodes that carry load [-]
  long nodes = 0, sliding = 0; // of all steps
  BURNISH_FIELDS(largest, nodes, sliding)
};

template <int Dim> class UnusedFriction final : public ObserverOf<UnusedFriction<Dim>, Dim> {
public:
  BURNISH_REMEMBERS(m_use)
  void look(const AcceptedStep<Dim>& step, FindingList&) override {
    m_use.resize(step.model().tools.size());
    for (int tool = 0; tool < static_cast<int>(m_use.size()); ++tool) {
      double load = 0, largest = 0;
      for (const auto& node : step.touching) {
        if (step.contact.nodes[node.candidate].tool != tool) continue;
        load += node.force.F.norm();
        largest = std::max(largest, node.force.part.N);
      }
      if (load > step.allowed.residual()) look_at_tool(step, tool, largest);
    }
  }
  void end(const EndedRun<Dim>& run, std::vector<Statement>& list) const override {
    for (int tool = 0; tool < static_cast<int>(m_use.size()); ++tool) {
      const FrictionUse& use = m_use[tool];
      const bool little = use.largest < USED, stuck = use.sliding == 0;
      if (use.nodes == 0 || !(little || stuck)) continue;
      const std::string name = run.step.tool_name(tool);
      list.push_back({StatementKind::NOT_NEEDED, "friction " + name, use.largest, little ? 41.0 : 40.0,
                      "friction of tool \"" + name + "\" never exceeds " + short_number(use.largest) +
                          " of its limit" + (stuck ? ", all nodes stick" : "") +
                          ": its coefficient is of no influence, sticking=true gives the same"});
    }
  }

private:
  void look_at_tool(const AcceptedStep<Dim>& step, int tool, double largest) {
    FrictionUse& use = m_use[tool];
    for (const auto& node : step.touching) {
      const ContactNode<Dim>& contact = step.contact.nodes[node.candidate];
      const double N = contact.has_ties ? node.deciding.force.N : node.force.part.N;
      if (contact.tool != tool || contact.tied || !(N > LOADED * largest)) continue;
      const TangentialLaw<Dim>& law = step.model().law(node.candidate, contact);
      if (law.frictionless() || law.friction().sticks_always()) continue;
      const double limit = law.capacity(node.deciding);
      if (!(limit > 0)) continue;
      ++use.nodes;
      use.sliding += contact.state == NodeState::SLIDING;
      use.largest = std::max(use.largest, node.deciding.force.T.norm() / limit);
    }
  }
  std::vector<FrictionUse> m_use; // per tool
};

} // namespace

BURNISH_OBSERVER(unused_friction, UnusedFriction)

} // namespace burnish
