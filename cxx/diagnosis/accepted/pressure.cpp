// Reported pressures against the nodal forces that they stand for (ALGORITHMS.md 16.2).
#include "base/sentence.hpp"
#include "contact/surface_report.hpp"
#include "diagnosis/accepted/contact_width.hpp"
#include "diagnosis/observers.hpp"
#include <cmath>

namespace burnish {
namespace {

constexpr double PRESSURE_SUM =
    0.15; // pressures of a tool against its forces, P2: warning; more in few edges

// The integral of a tool's pressure where it carried most.
struct PressureState {
  double load = 0; // sum of its normal forces there [force]
  double sum = 0;  // integral [force]
  double t = 0;
  BURNISH_FIELDS(load, sum, t)
};

// Of quadratic elements; pressures of linear ones are nodal forces over areas, which add up by themselves.
template <int Dim> class PressureCheck final : public ObserverOf<PressureCheck<Dim>, Dim> {
public:
  BURNISH_REMEMBERS(m_pressure, m_width)
  void look(const AcceptedStep<Dim>& step, FindingList& findings) override;

private:
  std::vector<PressureState> m_pressure; // per tool
  std::vector<ContactWidth> m_width;
};

// Tool that a facet's vertex counts for: its own, or that of another node of the facet, -1: none.
template <int Dim>
int tool_of(const AcceptedStep<Dim>& step, const std::vector<int>& candidate, const std::vector<int>& nodes,
            int vertex) {
  const auto touched = [&](int node) {
    const int i = candidate[node];
    return i >= 0 && in_contact(step.contact.nodes[i].state) ? step.contact.nodes[i].tool : -1;
  };
  int tool = touched(vertex);
  for (std::size_t k = 0; k < nodes.size() && tool < 0; ++k) tool = touched(nodes[k]);
  return tool;
}

// What the reported pressures ask of the mid nodes less what these carry, per tool [force]. The integral over all nodes is the
// sum of the forces by itself (METHOD.md 3.20).
template <int Dim>
Eigen::VectorXd lacking_at_middles(const AcceptedStep<Dim>& step, const SurfaceReport<Dim>& report) {
  const std::vector<int> candidate = candidate_of_node(step.model().candidates, step.mesh().num_nodes);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(step.model().tools.size()));
  std::vector<char> counted(step.contact.nodes.size(), 0); // in space a mid node is of two facets
  for (const Facet<Dim>& facet : step.setup.surface()) {
    const std::vector<int> nodes = nodes_of(facet);
    const Eigen::MatrixXd mass = step.body().measure->masses(places_of(step.body(), facet, step.u));
    for (int v = 0; v < Dim; ++v) {
      const int tool = tool_of(step, candidate, nodes, facet.vertex[v]), i = candidate[facet.vertex[v]];
      if (tool >= 0 && i >= 0) sum[tool] += mass.col(v).tail(mass.rows() - Dim).sum() * report.pressure[i];
    }
    for (std::size_t m = Dim; m < nodes.size(); ++m) {
      const int i = candidate[nodes[m]];
      if (i < 0 || counted[i] || !in_contact(step.contact.nodes[i].state)) continue;
      counted[i] = 1;
      sum[step.contact.nodes[i].tool] -= report.normal_force[i];
    }
  }
  return sum;
}

// Judged where the tool carries most, of the steps looked at, if it touches more than a few edges there: to fewer no
// pressure can be told, and the width of the contact says so.
template <int Dim>
void judge(const AcceptedStep<Dim>& step, int tool, const PressureState& known, const ContactWidth& width,
           FindingList& findings) {
  findings.withdraw("pressure sum", step.tool_name(tool));
  constexpr double per_edge = 2, at_the_ends = 0.5; // edges where the pressure may leave out what is there
  const double edges = (width.nodes - 1) / per_edge;
  if (!(known.load > 0) || edges <= FEW_EDGES) return;
  const double value = std::abs(known.sum / known.load - 1);
  findings.measure("pressure sum " + step.tool_name(tool), value);
  const double bound = PRESSURE_SUM + at_the_ends / edges;
  if (!(value > bound)) return;
  Finding* finding = findings.report("pressure sum", step.tool_name(tool), Severity::WARNING, value, known.t);
  finding->value = value;
  finding->bound = bound;
  finding->text = sentence(
      "tool \"", step.tool_name(tool), "\": its reported pressures ask for nodal forces of ", known.sum,
      ", its nodal forces to ", known.load, ", t = ", known.t,
      ": mid nodes of a curved surface off its curve (straight=), or a contact that the mesh does not "
      "resolve");
}

template <int Dim> void PressureCheck<Dim>::look(const AcceptedStep<Dim>& step, FindingList& findings) {
  const bool quadratic = step.mesh().nodes_per_element > Dim + 1;
  if (!quadratic || step.touching.empty()) return;
  m_pressure.resize(step.model().tools.size());
  m_width.resize(m_pressure.size());
  for (std::size_t tool = 0; tool < m_width.size(); ++tool)
    follow(step, static_cast<int>(tool), m_width[tool]);
  if (!step.tenth()) return;
  constexpr double carries = 0.5; // of the largest load: the last step counts too
  const auto tools = static_cast<Eigen::Index>(step.model().tools.size());
  Eigen::VectorXd load = Eigen::VectorXd::Zero(tools);
  for (const CheckedNode<Dim>& node : step.touching)
    load[step.contact.nodes[node.candidate].tool] += node.force.part.N;
  const SurfaceReport<Dim> report =
      surface_report(step.model(), step.body(), step.contact, step.setup.surface(), step.u, step.R);
  const Eigen::VectorXd sums = load + lacking_at_middles(step, report);
  for (int tool = 0; tool < tools; ++tool) {
    PressureState& known = m_pressure[tool];
    if (!(load[tool] > step.allowed.residual())) continue;
    const bool most = load[tool] >= known.load || (step.last && load[tool] > carries * known.load);
    if (most) known = {load[tool], sums[tool], step.t};
    if (most) judge(step, tool, known, m_width[tool], findings);
  }
}

} // namespace

BURNISH_OBSERVER(pressure_check, PressureCheck)

} // namespace burnish
