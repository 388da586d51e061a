// The last node of an open contact surface carries load: what lies beyond it touches nothing (ALGORITHMS.md 17.2).
#include "base/sentence.hpp"
#include "diagnosis/observers.hpp"
#include <map>

namespace burnish {
namespace {

constexpr double END_LOAD = 0.01; // load of that node over the largest one of the tool
constexpr double ALL_UNDER = 0.9; // a tool that touches this part of the surface covers it on purpose

// Largest load of a node at the end, beside that of its tool.
struct EndLoad {
  double force = 0, load = 0; // each the largest of the run [force]
  std::vector<double> place;
  double t = 0;
  BURNISH_FIELDS(force, load, place, t)
};

template <int Dim> class SurfaceEnd final : public ObserverOf<SurfaceEnd<Dim>, Dim> {
public:
  BURNISH_REMEMBERS(m_end, m_loads)
  void begin(const AcceptedStep<Dim>& step, FindingList& findings) override;
  void look(const AcceptedStep<Dim>& step, FindingList& findings) override;
  void end(const EndedRun<Dim>& run, std::vector<Statement>& list) const override;

private:
  std::vector<char> m_end;      // per candidate: the last one of an open contact surface, and not held
  std::vector<EndLoad> m_loads; // per tool
};

// In the plane. In space a contact may well reach the rim of its label, as that of a roll wider than its plate does.
template <int Dim> void SurfaceEnd<Dim>::begin(const AcceptedStep<Dim>& step, FindingList&) {
  m_end.assign(step.model().candidates.size(), 0);
  m_loads.resize(step.model().tools.size());
  if (Dim != 2) return;
  std::map<int, int> facets;
  for (const auto& facet : step.setup.surface())
    for (const int node : facet.vertex) ++facets[node];
  for (std::size_t i = 0; i < m_end.size(); ++i) {
    const int node = step.model().candidates[i];
    const auto found = facets.find(node);
    bool held = false;
    for (int c = 0; c < Dim; ++c) held = held || step.body().fixed[static_cast<std::size_t>(Dim * node + c)];
    m_end[i] = found != facets.end() && found->second == 1 && !held;
  }
}

template <int Dim> void SurfaceEnd<Dim>::look(const AcceptedStep<Dim>& step, FindingList&) {
  for (int tool = 0; tool < static_cast<int>(m_loads.size()); ++tool) {
    double load = 0;
    std::size_t nodes = 0;
    for (const auto& node : step.touching)
      if (step.contact.nodes[node.candidate].tool == tool) {
        load += node.force.F.norm();
        ++nodes;
      }
    if (!(load > step.allowed.residual())) continue;
    EndLoad& end = m_loads[tool];
    end.load = std::max(end.load, load);
    if (static_cast<double>(nodes) >= ALL_UNDER * static_cast<double>(step.contact.nodes.size())) continue;
    for (const auto& node : step.touching) {
      const double force = node.force.F.norm();
      if (step.contact.nodes[node.candidate].tool != tool || !m_end[node.candidate] || !(force > end.force))
        continue;
      end.force = force;
      end.place = step.place_of(node.x);
      end.t = step.t;
    }
  }
}

template <int Dim> void SurfaceEnd<Dim>::end(const EndedRun<Dim>& run, std::vector<Statement>& list) const {
  for (int tool = 0; tool < static_cast<int>(m_loads.size()); ++tool) {
    const EndLoad& end = m_loads[tool];
    const double share = end.load > 0 ? end.force / end.load : 0;
    if (!(share > END_LOAD)) continue;
    const std::string name = run.step.tool_name(tool);
    list.push_back({StatementKind::NEEDED, "end of surface " + name, share, 95,
                    "the last node of the contact surface, at " + place_text(end.place) + ", carries " +
                        short_number(100 * share) + " % of the largest load of tool \"" + name +
                        "\" at t = " + short_number(end.t) +
                        ": what lies beyond it touches nothing, label= may take it in"});
  }
}

} // namespace

BURNISH_OBSERVER(surface_end, SurfaceEnd)

} // namespace burnish
