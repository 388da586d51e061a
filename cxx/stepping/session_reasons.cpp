// Why a step or an approach failed, for messages.
#include "base/error.hpp"
#include "stepping/session.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {

template <int Dim> void Session<Dim>::fail_approach(int tool, const std::string& coordinate) const {
  const double h = m_corrector->body().spacing, radius = m_model.tools[tool]->profile().tightest_radius();
  std::ostringstream small;
  if (radius < h)
    small << " (its tightest radius, " << radius << ", is smaller than the distance of the contact nodes, "
          << h << ": it may pass between them)";
  fail("contact.approach", "coordinate \"" + coordinate + "\" of tool \"" + m_tools[tool]->name() +
                               "\" alone does not bring it to the body" + small.str() +
                               "; place the tool opposite the contact surface first");
}

// Halving the step makes a motion smaller, unless the program jumps.
template <int Dim> std::string Session<Dim>::jump() const {
  if (m_dt > 1e-3 * m_largest_dt || m_accepted.q.size() != m_program.value.size()) return "";
  const auto poses = m_model.poses(m_accepted.q);
  for (std::size_t t = 0; t < m_tools.size(); ++t)
    for (std::size_t k = 0; k < poses[t].origin_q.size(); ++k) {
      const int at = m_model.first[t] + static_cast<int>(k);
      const double change = m_program.value[at] - m_accepted.q[at];
      const double lever =
          poses[t].origin_q[k].norm() + poses[t].R_q[k].norm() * m_model.tools[t]->profile().length_scale();
      if (!m_program.is_motion[at] || std::abs(change) * lever < 1e-2 * m_corrector->body().spacing) continue;
      std::ostringstream text;
      text << "; the program moves " << m_model.coordinate(at) << " by " << change << " at once, from "
           << m_accepted.q[at] << " at t = " << m_t << ": after a force go on from value(...)";
      return text.str();
    }
  return "";
}

// A node that passes the end of an open profile loses its force there at once: no step is small enough.
template <int Dim> std::string Session<Dim>::profile_end() const {
  const auto poses = m_model.poses(m_accepted.q);
  for (std::size_t i = 0; i < m_accepted.nodes.size(); ++i) {
    const auto& node = m_accepted.nodes[i];
    if (!in_contact(node.state)) continue;
    const auto& tool = *m_model.tools[node.tool];
    const ParamRange<Dim> range = tool.profile().range();
    const double speed = tool.surface(poses[node.tool], node.s).x_s.col(0).norm();
    const double away = std::min((node.s - range.begin).norm(), (range.end - node.s).norm()) * speed;
    if (range.closed || away > 0.5 * m_corrector->body().spacing) continue;
    std::ostringstream text;
    text << "; node " << m_candidates[i] << " in contact is " << away
         << " from the end of the profile of tool \"" << tool.name()
         << "\", where the contact ends with a jump: let the profile go on and bend away from the "
         << "workpiece (chain= with a fillet)";
    return text.str();
  }
  return "";
}

template <int Dim> std::string Session<Dim>::reason() const {
  if (!started()) return "";
  const std::string jumps = jump(); // of a step that the material could not follow: the only reason here
  if (m_corrector->reason().empty()) return jumps;
  return m_corrector->reason() + (jumps.empty() ? profile_end() : jumps);
}

template void Session<2>::fail_approach(int, const std::string&) const;
template std::string Session<2>::jump() const;
template std::string Session<2>::profile_end() const;
template std::string Session<2>::reason() const;

} // namespace burnish
