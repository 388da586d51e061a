// Integrity of the points of a workpiece: damage and healing, METHOD.md 1.12.
#include "base/error.hpp"
#include "workpiece/workpiece.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

/// An integrity this near to its goal has reached it: parts of steps add up to whole ones but for rounding.
constexpr double REACHED = 1e-12;

} // namespace

template <int Dim> void Workpiece<Dim>::track_integrity() {
  if (m_user)
    fail("Workpiece::track_integrity", "the law is user-defined, expected a law of the core: the stress that "
                                       "a script keeps cannot be forgotten");
  if (tracks_integrity()) return;
  for (WorkpieceState<Dim>* state : {&m_state_old, &m_state}) {
    state->integrity.assign(m_discretization.num_points(), 1);
    state->integrity_rate.assign(m_discretization.num_points(), 0);
    state->integrity_goal.assign(m_discretization.num_points(), 1);
  }
}

template <int Dim> void Workpiece<Dim>::change_integrity(int point, double goal, int steps) {
  const char* where = "Workpiece::change_integrity";
  require_point(where, point);
  if (!tracks_integrity()) fail(where, "no integrity is tracked, call track_integrity first");
  if (m_updated) fail(where, "a step is under way, expected a call between steps, as in record");
  require(goal > 0 && goal <= 1, where, "goal", goal, "0 < goal <= 1");
  require(steps >= 1, where, "steps", steps, ">= 1");
  const double w = m_state_old.integrity[point];
  for (WorkpieceState<Dim>* state : {&m_state_old, &m_state}) {
    state->integrity_rate[point] = (goal - w) / steps;
    state->integrity_goal[point] = goal;
  }
}

template <int Dim> void Workpiece<Dim>::set_step_length(double length) {
  require(length >= 0 && std::isfinite(length), "Workpiece::set_step_length", "length", length,
          "finite >= 0");
  m_step_length = length;
}

template <int Dim> double Workpiece<Dim>::integrity(int point) const {
  require_point("Workpiece::integrity", point);
  return tracks_integrity() ? m_state.integrity[point] : 1;
}

template <int Dim> Stress<Dim> Workpiece<Dim>::stress(int point) const {
  require_point("Workpiece::stress", point);
  const Stress<Dim> effective = point_now(point).stress;
  return tracks_integrity() ? Stress<Dim>(m_state.integrity[point] * effective) : effective;
}

// METHOD.md (1.28): integrities at the end of a step or of a part of one.
template <int Dim> void Workpiece<Dim>::move_integrity(double dt) {
  const double share = m_step_length > 0 ? std::min(1., dt / m_step_length) : 1;
  m_healing = false;
  for (std::size_t p = 0; p < m_state.integrity.size(); ++p) {
    const double rate = m_state_old.integrity_rate[p], goal = m_state_old.integrity_goal[p];
    const double w = m_state_old.integrity[p] + share * rate;
    const bool reached = rate < 0 ? w <= goal + REACHED : w >= goal - REACHED;
    m_state.integrity[p] = rate == 0 ? m_state_old.integrity[p] : (reached ? goal : w);
    m_state.integrity_rate[p] = reached ? 0 : rate;
    m_state.integrity_goal[p] = goal;
    m_healing = m_healing || rate > 0;
  }
  if (m_healing) heal_start();
}

// METHOD.md (1.29): the part that has healed in this step is free of stress and new, the rest keeps what it carries.
template <int Dim> void Workpiece<Dim>::heal_start() {
  m_start = m_state_old;
  const std::vector<double> initial = m_law->internal_variables().initial();
  for (std::size_t p = 0; p < m_state.integrity.size(); ++p) {
    if (!(m_state_old.integrity_rate[p] > 0)) continue;
    const double old_part = m_state_old.integrity[p] / m_state.integrity[p];
    for (std::size_t k = 0; k < num_stress<Dim>; ++k) m_start.stress[p * num_stress<Dim> + k] *= old_part;
    for (int k = 0; k < m_num_internal; ++k) {
      double& value = m_start.internal[p * m_num_internal + k];
      value = initial[k] + old_part * (value - initial[k]);
    }
    m_start.plastic[p] = 0;
  }
}

// clang-format off
#define BURNISH_INTEGRITY(Dim)                                                                                         \
  template void Workpiece<Dim>::track_integrity();                                                                     \
  template void Workpiece<Dim>::change_integrity(int, double, int);                                                    \
  template void Workpiece<Dim>::set_step_length(double);                                                               \
  template double Workpiece<Dim>::integrity(int) const;                                                                \
  template Stress<Dim> Workpiece<Dim>::stress(int) const;                                                              \
  template void Workpiece<Dim>::move_integrity(double);                                                                \
  template void Workpiece<Dim>::heal_start();
// clang-format on
BURNISH_INTEGRITY(2)
BURNISH_INTEGRITY(3)

} // namespace burnish
