// Tools that touched nothing (ALGORITHMS.md 17.1).
#include "diagnosis/before/wrong_side.hpp"
#include "diagnosis/observers.hpp"
#include <algorithm>

namespace burnish {
namespace {

template <int Dim> class IdleTools final : public ObserverOf<IdleTools<Dim>, Dim> {
public:
  BURNISH_REMEMBERS(m_touched)
  void look(const AcceptedStep<Dim>& step, FindingList& findings) override {
    m_touched.resize(step.model().tools.size());
    for (const auto& node : step.contact.nodes)
      if (in_contact(node.state)) m_touched[node.tool] = 1;
    const bool any = std::find(m_touched.begin(), m_touched.end(), 1) != m_touched.end();
    if (any || !step.last || !step.u.isZero(0)) return;
    Finding* finding = findings.report("idle tools", "", Severity::WARNING, 0, step.t);
    if (finding)
      finding->text =
          "no tool has touched the workpiece, and nothing else has moved it: look at the signs of the "
          "program's motions, and at the side that the tools are on";
  }
  void end(const EndedRun<Dim>& run, std::vector<Statement>& list) const override {
    for (int tool = 0; tool < static_cast<int>(m_touched.size()); ++tool) {
      if (m_touched[tool]) continue;
      const std::string name = run.step.tool_name(tool);
      list.push_back({StatementKind::NOT_NEEDED, "tool " + name, 0, 95,
                      "tool \"" + name +
                          "\" touched nothing: the workpiece is the same without it, or it faces away (" +
                          side_of_the_body<Dim>() + ")"});
    }
  }

private:
  std::vector<char> m_touched; // per tool
};

} // namespace

BURNISH_OBSERVER(idle_tools, IdleTools)

} // namespace burnish
