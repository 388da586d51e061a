// Tools that touched nothing (ALGORITHMS.md 17.1).
#include "diagnosis/before/wrong_side.hpp"
#include "diagnosis/observers.hpp"

namespace burnish {
namespace {

template <int Dim> class IdleTools final : public ObserverOf<IdleTools<Dim>, Dim> {
public:
  BURNISH_REMEMBERS(m_touched)
  void look(const AcceptedStep<Dim>& step, FindingList&) override {
    m_touched.resize(step.model().tools.size());
    for (const auto& node : step.contact.nodes)
      if (in_contact(node.state)) m_touched[node.tool] = 1;
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
