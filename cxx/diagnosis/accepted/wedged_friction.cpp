// Nodes that friction holds with much more than their normal force (ALGORITHMS.md 16.2).
#include "base/sentence.hpp"
#include "diagnosis/observers.hpp"
#include <algorithm>
#include <iomanip>

namespace burnish {
namespace {

constexpr double WEDGED = 4; // friction over the normal force of a node
constexpr double CARRYING =
    1e-2; // a node carries load if its friction is this part of the forces of all, the largest so far

template <int Dim> class WedgedFriction final : public ObserverOf<WedgedFriction<Dim>, Dim> {
public:
  BURNISH_REMEMBERS(m_load)
  void look(const AcceptedStep<Dim>& step, FindingList& findings) override {
    double load = 0;
    for (const auto& node : step.touching) load += node.force.F.norm();
    m_load = std::max(m_load, load);
    for (const auto& node : step.touching) {
      const ContactNode<Dim>& contact = step.contact.nodes[node.candidate];
      const SurfaceForce<Dim>& force = node.deciding.force;
      const double T = force.T.norm();
      if (contact.tied || !(T > WEDGED * force.N) || !(T > CARRYING * m_load) || !(force.N > 0)) continue;
      if (step.model().law(node.candidate, contact).friction().sticks_always()) continue;
      const std::string tool = step.tool_name(contact.tool);
      Finding* finding = findings.report("wedged friction", tool, Severity::WARNING, T / force.N, step.t);
      if (!finding) continue;
      finding->value = T / force.N;
      finding->bound = WEDGED;
      finding->place = step.place_of(node.x);
      finding->text =
          sentence("friction of tool \"", tool, "\" holds a node with ", std::setprecision(2), T / force.N,
                   " times its normal force", std::setprecision(6), step.at(node.x),
                   ": with so much friction there is more than one equilibrium, and which is found depends "
                   "on the steps; sticking=true says that nothing slides");
    }
  }

private:
  double m_load = 0;
};

} // namespace

BURNISH_OBSERVER(wedged_friction, WedgedFriction)

} // namespace burnish
