#include "checks/pressure_check.hpp"
#include "contact/surface_report.hpp"
#include <cmath>
#include <sstream>

namespace burnish {
namespace {

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

// Integral of the fitted pressure per tool [force].
template <int Dim> Eigen::VectorXd integrals(const AcceptedStep<Dim>& step, const Eigen::VectorXd& pressure) {
  const std::vector<int> candidate = step.model.candidate_of_node(step.mesh.num_nodes);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(step.model.tools.size()));
  for (const Facet<Dim>& facet : step.surface) {
    const std::vector<int> nodes = nodes_of(facet);
    const Eigen::VectorXd part =
        step.body.measure->masses(places_of(step.body, facet, step.u)).colwise().sum();
    for (int v = 0; v < Dim; ++v) {
      const int tool = tool_of(step, candidate, nodes, facet.vertex[v]);
      if (tool >= 0 && candidate[facet.vertex[v]] >= 0)
        sum[tool] += part[v] * pressure[candidate[facet.vertex[v]]];
    }
  }
  return sum;
}

} // namespace

template <int Dim>
void PressureCheck<Dim>::look(const AcceptedStep<Dim>& step, const CheckOptions& options, CheckState& state,
                              FindingList& findings) {
  constexpr double carries = 0.1; // part of the largest load of the tool: less is not worth a look
  const bool quadratic = step.mesh.nodes_per_element > Dim + 1;
  if (!quadratic || step.touching.empty()) return;
  if (state.steps % options.seldom != 0 && !step.last) return;
  const SurfaceReport<Dim> report =
      surface_report(step.model, step.body, step.contact, step.surface, step.u, step.R);
  const Eigen::VectorXd sums = integrals(step, report.pressure_fit);
  for (int tool = 0; tool < static_cast<int>(step.model.tools.size()); ++tool) {
    double force = 0;
    for (std::size_t i = 0; i < step.contact.nodes.size(); ++i)
      if (in_contact(step.contact.nodes[i].state) && step.contact.nodes[i].tool == tool)
        force += report.normal_force[static_cast<Eigen::Index>(i)];
    if (!(force > carries * state.width[tool].load) || !(force > step.tolerance * step.load)) continue;
    const double value = std::abs(sums[tool] / force - 1);
    state.largest("pressure sum", value);
    if (!(value > options.pressure_sum)) continue;
    Finding* finding =
        findings.report("pressure sum", step.tool_name(tool), Severity::WARNING, value, step.t);
    if (!finding) continue;
    finding->value = value;
    finding->bound = options.pressure_sum;
    std::ostringstream text;
    text << "tool \"" << step.tool_name(tool) << "\": the fitted pressures add up to " << sums[tool]
         << ", the nodal forces to " << force << ", t = " << step.t
         << ": the mid nodes of the surface are not where the pressure is";
    finding->text = text.str();
  }
}

template class PressureCheck<2>;
template class PressureCheck<3>;

} // namespace burnish
