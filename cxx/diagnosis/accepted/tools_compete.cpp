// Nodes in contact with one tool that another tool reaches for too, and elements that touch two tools.
#include "base/sentence.hpp"
#include "diagnosis/observers.hpp"

namespace burnish {
namespace {

template <int Dim> class ToolsCompete final : public ObserverOf<ToolsCompete<Dim>, Dim> {
public:
  void look(const AcceptedStep<Dim>& step, FindingList& findings) override;

private:
  void look_at_node(const AcceptedStep<Dim>& step, const CheckedNode<Dim>& node, FindingList& findings) const;
  void look_at_elements(const AcceptedStep<Dim>& step, FindingList& findings) const;
};

template <int Dim>
void ToolsCompete<Dim>::look_at_node(const AcceptedStep<Dim>& step, const CheckedNode<Dim>& node,
                                     FindingList& findings) const {
  const ContactModel<Dim>& model = step.model();
  const int own = step.contact.nodes[node.candidate].tool;
  for (int other = 0; other < static_cast<int>(model.tools.size()); ++other) {
    if (other == own || !model.may_touch(node.candidate, other)) continue;
    const double gap = model.tools[other]->foot(step.poses[other], node.x, Param<Dim>::Zero()).gap;
    if (gap >= -step.allowed.offset) continue;
    const std::string a = step.tool_name(own), b = step.tool_name(other);
    Finding* finding = findings.report("contact", "node " + a + " " + b, Severity::WARNING, 0, step.t);
    if (!finding) continue;
    finding->place = step.place_of(node.x);
    finding->text =
        sentence("tools \"", a, "\" and \"", b, "\" reach for the same node ",
                 model.candidates[node.candidate], step.at(node.x), ": it stays with \"", a, "\", and \"", b,
                 "\" overlaps it by ", -gap, "; a node touches at most one tool");
  }
}

template <int Dim>
void ToolsCompete<Dim>::look_at_elements(const AcceptedStep<Dim>& step, FindingList& findings) const {
  const Mesh<Dim>& mesh = step.mesh();
  std::vector<int> tool_of_node(static_cast<std::size_t>(mesh.num_nodes), -1);
  for (const CheckedNode<Dim>& node : step.touching)
    tool_of_node[step.model().candidates[node.candidate]] = step.contact.nodes[node.candidate].tool;
  for (int e = 0; e < mesh.num_elements; ++e) {
    int first = -1;
    for (int a = 0; a < mesh.nodes_per_element; ++a) {
      const int node = mesh.element(e)[a], tool = tool_of_node[node];
      if (tool < 0) continue;
      if (first < 0) first = tool;
      if (tool == first) continue;
      // in the order of the tools, whichever the element names first
      const std::string low = step.tool_name(std::min(first, tool)),
                        high = step.tool_name(std::max(first, tool));
      Finding* finding =
          findings.report("contact", "element " + low + " " + high, Severity::WARNING, 0, step.t);
      if (finding)
        finding->text =
            sentence("an element lies between tools \"", low, "\" and \"", high, "\" (element ", e,
                     step.at(step.body().position(step.u, node)), "): refine the workpiece there");
    }
  }
}

template <int Dim> void ToolsCompete<Dim>::look(const AcceptedStep<Dim>& step, FindingList& findings) {
  if (step.model().tools.size() < 2) return;
  for (const CheckedNode<Dim>& node : step.touching) look_at_node(step, node, findings);
  look_at_elements(step, findings);
}

} // namespace

BURNISH_OBSERVER(tools_compete, ToolsCompete)

} // namespace burnish
