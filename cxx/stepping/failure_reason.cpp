#include "stepping/failure_reason.hpp"
#include <cmath>
#include <sstream>

namespace burnish {

template <int Dim> std::string program_jump(const ContactSetup<Dim>& setup, const FailedStep<Dim>& step) {
  constexpr double short_step = 1e-3; // of the largest step: a motion is small by then
  constexpr double jump = 1e-2;       // motion of a tool's points that is not, over the spacing of candidates
  const auto& q = step.state->q;
  if (step.dt > short_step * step.largest_dt || q.size() != step.prescribed->value.size()) return "";
  const auto poses = setup.model().poses(q);
  for (std::size_t t = 0; t < setup.tools().size(); ++t)
    for (std::size_t k = 0; k < poses[t].origin_q.size(); ++k) {
      const int at = setup.model().first[t] + static_cast<int>(k);
      const double change = step.prescribed->value[at] - q[at];
      const double lever = poses[t].origin_q[k].norm() +
                           poses[t].R_q[k].norm() * setup.model().tools[t]->surface().length_scale();
      if (!step.prescribed->is_motion[at] || std::abs(change) * lever < jump * setup.body().spacing) continue;
      std::ostringstream text;
      text << "; the program moves " << setup.model().coordinate(at) << " by " << change << " at once, from "
           << q[at] << " at t = " << step.t << ": after a force go on from value(...)";
      return text.str();
    }
  return "";
}

template <int Dim> std::string end_of_tool(const ContactSetup<Dim>& setup, const ContactState<Dim>& state) {
  constexpr double near = 0.5; // of the spacing of candidates
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    const auto& node = state.nodes[i];
    if (!in_contact(node.state)) continue;
    const auto& tool = *setup.model().tools[node.tool];
    const double away = tool.surface().distance_to_end(node.place);
    if (away > near * setup.body().spacing) continue;
    std::ostringstream text;
    text << "; node " << setup.candidates()[i] << " in contact is " << away
         << " from the end of the profile of tool \"" << tool.name()
         << "\", where the contact ends with a jump: let the profile go on and curve away from the "
         << "workpiece (chain= with a fillet)";
    return text.str();
  }
  return "";
}

template std::string program_jump<2>(const ContactSetup<2>&, const FailedStep<2>&);
template std::string program_jump<3>(const ContactSetup<3>&, const FailedStep<3>&);
template std::string end_of_tool<2>(const ContactSetup<2>&, const ContactState<2>&);
template std::string end_of_tool<3>(const ContactSetup<3>&, const ContactState<3>&);

} // namespace burnish
