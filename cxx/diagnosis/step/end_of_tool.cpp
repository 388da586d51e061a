// Contact at an end of an open tool, beyond which the surface of the body goes on: a sharp edge, where the force is lost at once.
#include "base/sentence.hpp"
#include "diagnosis/observers.hpp"

namespace burnish {
namespace {

constexpr double CLOSE = 0.5; // of the spacing of candidates: a node about to pass the end

template <int Dim> class EndOfTool final : public ObserverOf<EndOfTool<Dim>, Dim> {
public:
  void look(const AcceptedStep<Dim>& step, FindingList& findings) override;
  void explain(const FailedStep<Dim>& step, std::vector<Failure>& causes) const override;
};

template <int Dim> void EndOfTool<Dim>::look(const AcceptedStep<Dim>& step, FindingList& findings) {
  constexpr double near = 2, at = 1; // of the spacing: nodes looked at, and contact nodes at the end
  const BodyView<Dim>& body = step.body();
  for (int tool = 0; tool < static_cast<int>(step.model().tools.size()); ++tool) {
    const auto& placed = *step.model().tools[tool];
    for (const SurfacePlace<Dim>& place : placed.surface().ends()) {
      const Vector<Dim> end = placed.position(step.poses[tool], place);
      bool touches = false, beyond = false;
      for (std::size_t i = 0; i < step.contact.nodes.size(); ++i) {
        const auto& node = step.contact.nodes[i];
        const Vector<Dim> x = body.position(step.u, step.model().candidates[i]);
        const double distance = (x - end).norm();
        if (distance > near * body.spacing || !step.model().may_touch(static_cast<int>(i), tool)) continue;
        if (in_contact(node.state) && node.tool == tool)
          touches = touches || distance <= at * body.spacing;
        else
          beyond = beyond || placed.foot(step.poses[tool], x, place.hint).on_end;
      }
      if (!touches || !beyond) continue;
      Finding* finding = findings.report("contact", "end " + placed.name(), Severity::WARNING, 0, step.t);
      if (!finding) continue;
      finding->place = step.place_of(end);
      finding->text =
          sentence("the contact has reached the end of tool \"", placed.name(), "\"", step.at(end),
                   ": the tool is sharp there; let its profile go on, with a fillet");
    }
  }
}

template <int Dim>
void EndOfTool<Dim>::explain(const FailedStep<Dim>& step, std::vector<Failure>& causes) const {
  const auto poses = step.setup.model().poses(step.state.q);
  for (std::size_t i = 0; i < step.state.nodes.size(); ++i) {
    const auto& node = step.state.nodes[i];
    if (!in_contact(node.state)) continue;
    const double away =
        poses[node.tool].size * step.setup.model().tools[node.tool]->surface().distance_to_end(node.place);
    if (away > CLOSE * step.setup.body().spacing) continue;
    Failure failure(Cause::END_OF_TOOL);
    failure.tool = node.tool;
    failure.node = step.setup.candidates()[i];
    failure.value = away;
    causes.push_back(failure);
    return;
  }
}

} // namespace

BURNISH_OBSERVER(end_of_tool, EndOfTool)

} // namespace burnish
