// A contact that is no more than a few nodes (ALGORITHMS.md 16.2).
#include "diagnosis/accepted/contact_width.hpp"
#include "base/sentence.hpp"
#include "diagnosis/observers.hpp"
#include "iteration/contact_window.hpp"
#include <cmath>

namespace burnish {
namespace {

// Nodes next to one another that one tool touches.
struct Run {
  int nodes = 0; // in space across it, where it is narrowest
  double load = 0;
  std::vector<double> place;
};

std::vector<Run> runs_of(const AcceptedStep<2>& step, int tool) {
  constexpr int jump = 2; // candidates further apart than this are not neighbors
  std::vector<Run> runs;
  int last = -1;
  for (const CheckedNode<2>& node : step.touching) {
    if (step.contact.nodes[node.candidate].tool != tool) continue;
    if (runs.empty() || node.candidate - last > jump) runs.push_back({});
    Run& run = runs.back();
    ++run.nodes;
    last = node.candidate;
    run.load += node.force.F.norm();
    if (run.place.empty()) run.place = step.place_of(node.x);
  }
  return runs;
}

// The patch of neighbors that holds touching node k. @param of in: per candidate its number among them, -1: none, or in a patch
Run patch_of(const AcceptedStep<3>& step, int k, std::vector<int>& of) {
  Run run;
  std::vector<Vector<3>> places;
  std::vector<int> open{k};
  of[step.touching[k].candidate] = -1;
  while (!open.empty()) {
    const CheckedNode<3>& node = step.touching[open.back()];
    open.pop_back();
    places.push_back(node.x);
    run.load += node.force.F.norm();
    for (const int next : step.model().neighbors[node.candidate])
      if (of[next] >= 0) {
        open.push_back(of[next]);
        of[next] = -1;
      }
  }
  run.place = step.place_of(places.front());
  run.nodes = 1 + static_cast<int>(std::lround(least_width(places) / step.body().spacing));
  return run;
}

std::vector<Run> runs_of(const AcceptedStep<3>& step, int tool) {
  std::vector<int> of(step.model().candidates.size(), -1);
  for (std::size_t k = 0; k < step.touching.size(); ++k)
    if (step.contact.nodes[step.touching[k].candidate].tool == tool)
      of[step.touching[k].candidate] = static_cast<int>(k);
  std::vector<Run> runs;
  for (std::size_t k = 0; k < step.touching.size(); ++k)
    if (of[step.touching[k].candidate] >= 0) runs.push_back(patch_of(step, static_cast<int>(k), of));
  return runs;
}

template <int Dim> class ContactWidthCheck final : public ObserverOf<ContactWidthCheck<Dim>, Dim> {
public:
  BURNISH_REMEMBERS(m_width)
  void look(const AcceptedStep<Dim>& step, FindingList& findings) override;

private:
  std::vector<ContactWidth> m_width; // per tool
};

template <int Dim> void ContactWidthCheck<Dim>::look(const AcceptedStep<Dim>& step, FindingList& findings) {
  m_width.resize(step.model().tools.size());
  const double few = few_nodes(step.mesh());
  for (int tool = 0; tool < static_cast<int>(m_width.size()); ++tool) {
    ContactWidth& width = m_width[tool];
    if (!follow(step, tool, width)) continue;
    const std::string name = step.tool_name(tool);
    findings.measure("contact nodes " + name, width.nodes);
    findings.withdraw("contact width", name);
    if (width.nodes > few) continue;
    Finding* finding = findings.report("contact width", name, Severity::WARNING, 0, width.t);
    finding->value = width.nodes;
    finding->bound = few;
    finding->place = width.place;
    finding->count = width.narrow;
    finding->text = sentence("tool \"", name, "\" touches only ", width.nodes,
                             width.nodes == 1 ? " node" : " nodes in a row", " where it carries most, at ",
                             place_text(width.place), ", t = ", width.t, ", and ", few, " or fewer in ",
                             width.narrow, " of ", width.steps, " steps: refine the surface there");
  }
}

} // namespace

template <int Dim> double few_nodes(const Mesh<Dim>& mesh) {
  const int per_edge = mesh.nodes_per_element == Dim + 1 ? 1 : 2;
  return per_edge * FEW_EDGES + 1;
}

template <int Dim> bool follow(const AcceptedStep<Dim>& step, int tool, ContactWidth& width) {
  constexpr double carries = 0.1;    // a part of the contact that carries this part of the load counts
  constexpr double at_the_end = 0.5; // of the largest load: the last step counts too
  double load = 0;
  const std::vector<Run> runs = runs_of(step, tool);
  for (const Run& run : runs) load += run.load;
  if (runs.empty() || !(load > step.allowed.residual())) return false;
  const Run* few = nullptr;
  for (const Run& run : runs)
    if (run.load >= carries * load && (!few || run.nodes < few->nodes)) few = &run;
  if (!few) return false;
  ++width.steps;
  width.narrow += few->nodes <= few_nodes(step.mesh());
  if (load >= width.load || (step.last && load > at_the_end * width.load && few->nodes < width.nodes)) {
    width.nodes = few->nodes;
    width.place = few->place;
    width.t = step.t;
  }
  width.load = std::max(width.load, load);
  return true;
}

BURNISH_OBSERVER(contact_width_check, ContactWidthCheck)
template bool follow<2>(const AcceptedStep<2>&, int, ContactWidth&);
template bool follow<3>(const AcceptedStep<3>&, int, ContactWidth&);
template double few_nodes<2>(const Mesh<2>&);
template double few_nodes<3>(const Mesh<3>&);

} // namespace burnish
