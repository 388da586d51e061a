// The verbs of a session that concern events: finding, taking and logging them.
#include "base/error.hpp"
#include "stepping/session.hpp"
#include <algorithm>

namespace burnish {

// A coordinate under force that only friction resists needs a sticking node. Where the last one has just begun
// to slide, the neutral point moves on toward the nodes that slide the other way: the one of them that slipped
// least sticks; it and those of its own direction are the last resort. Pure rates keep the node that has just begun
// to slide: their forces are not in balance, and nodes would take turns without end (article's scheme: 4208 events).
template <int Dim>
void Session<Dim>::keep_support(ContactState<Dim>& state,
                                const std::vector<ContactEvent<Dim>>& events) const {
  const std::vector<ContactNode<Dim>> before = state.nodes;
  std::vector<char> refused(before.size(), 0);
  for (const auto& event : events) {
    const bool slides = event.candidate >= 0 && event.kind == EventKind::STICK_TO_SLIP;
    if (!slides || m_stepping == Stepping::RATES) continue;
    for (std::size_t i = 0; i < before.size(); ++i)
      if (before[i].tool == event.tool && before[i].slip_sign == event.slip_sign) refused[i] = 1;
  }
  for (int i; (i = ensure_support(m_model, m_program, state, refused)) >= 0;) {
    state.nodes[i].s = state.nodes[i].s_ref = before[i].s; // from here on, not from the start of the step
    state.nodes[i].slip_rate = 0;
  }
}

// Candidates whose stick is the only one that holds their tool. Pure rates do not let them go, see above.
template <int Dim> std::vector<int> Session<Dim>::supports() const {
  std::vector<int> result;
  for (std::size_t t = 0; t < m_tools.size(); ++t) {
    int last = -1, number = 0;
    for (std::size_t i = 0; i < m_accepted.nodes.size(); ++i) {
      const auto& node = m_accepted.nodes[i];
      if (!holds(node.state) || node.tool != static_cast<int>(t)) continue;
      last = static_cast<int>(i);
      ++number;
    }
    if (number != 1) continue;
    ContactState<Dim> without = m_accepted;
    without.nodes[last].state = NodeState::SLIDING;
    if (ensure_support(m_model, m_program, without) >= 0) result.push_back(last);
  }
  return result;
}

template <int Dim>
std::vector<ContactEvent<Dim>> Session<Dim>::events(const Eigen::VectorXd& u, const Eigen::VectorXd& R,
                                                    double tolerance, double until) const {
  require(tolerance >= 0, "contact.events", "tolerance", tolerance, ">= 0");
  const auto& options = m_corrector->options();
  const double h = m_corrector->body().spacing;
  const EventTolerance tolerances{options.tolerance * std::max(m_corrector->load_scale(), 1e-300),
                                  options.gap_tolerance * h, tolerance};
  auto found =
      earliest_events(model(), m_corrector->body(),
                      StepEnds<Dim>{&m_accepted, &m_corrector->state(), &m_u, &u, &m_R, &R, m_t, m_dt},
                      tolerances, m_stepping == Stepping::RATES ? supports() : std::vector<int>());
  found.erase(std::remove_if(found.begin(), found.end(),
                             [&](const auto& event) { return event.fraction > until + tolerance; }),
              found.end());
  return found;
}

template <int Dim> void Session<Dim>::switch_states(const std::vector<ContactEvent<Dim>>& events) {
  apply_events(model(), m_corrector->body(), events, m_u, m_accepted);
  keep_support(m_accepted, events);
  m_log.insert(m_log.end(), events.begin(), events.end());
}

namespace {

EventKind kind_for(PointChange change) {
  if (change == PointChange::SCRIPT) return EventKind::SCRIPT;
  return change == PointChange::YIELD ? EventKind::YIELD : EventKind::UNLOADING;
}

} // namespace

template <int Dim> void Session<Dim>::log(const std::vector<ElementEvent<Dim>>& events) {
  auto first = static_cast<std::ptrdiff_t>(m_log.size()); // of this step's element events
  while (first > 0 && m_log[first - 1].candidate < 0 && m_log[first - 1].t >= m_t) --first;
  for (const auto& found : events) {
    ContactEvent<Dim> event;
    event.t = m_t + found.fraction * m_dt;
    event.fraction = found.fraction;
    event.kind = kind_for(found.change);
    event.node = found.point;
    event.x = found.x;
    event.name = found.name;
    m_log.push_back(event);
  }
  std::stable_sort(m_log.begin() + first, m_log.end(),
                   [](const auto& a, const auto& b) { return a.t < b.t; });
}

// members of this file; session.cpp instantiates the others
template std::vector<int> Session<2>::supports() const;
template void Session<2>::keep_support(ContactState<2>&, const std::vector<ContactEvent<2>>&) const;
template std::vector<ContactEvent<2>> Session<2>::events(const Eigen::VectorXd&, const Eigen::VectorXd&,
                                                         double, double) const;
template void Session<2>::switch_states(const std::vector<ContactEvent<2>>&);
template void Session<2>::log(const std::vector<ElementEvent<2>>&);

} // namespace burnish
