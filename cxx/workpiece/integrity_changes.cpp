#include "workpiece/integrity_changes.hpp"
#include "base/error.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

/// An integrity this near to its goal has reached it: parts of steps add up to whole ones but for rounding.
constexpr double REACHED = 1e-12;

} // namespace

template <int Dim> void IntegrityChanges<Dim>::set_step_length(double length) {
  require(length >= 0 && std::isfinite(length), "set_step_length", "length", length, "finite >= 0");
  m_step_length = length;
}

// METHOD.md (1.28).
template <int Dim>
void IntegrityChanges<Dim>::move(const WorkpieceState<Dim>& old, WorkpieceState<Dim>& now) {
  const double share = m_step_length > 0 ? std::min(1., now.dt / m_step_length) : 1;
  m_healing = false;
  for (std::size_t p = 0; p < now.integrity.size(); ++p) {
    const double rate = old.integrity_rate[p], goal = old.integrity_goal[p];
    const double w = old.integrity[p] + share * rate;
    const bool reached = rate < 0 ? w <= goal + REACHED : w >= goal - REACHED;
    now.integrity[p] = rate == 0 ? old.integrity[p] : (reached ? goal : w);
    now.integrity_rate[p] = reached ? 0 : rate;
    now.integrity_goal[p] = goal;
    m_healing = m_healing || rate > 0;
  }
  if (m_healing) heal(old, now);
}

// METHOD.md (1.29): the part that has healed in this step is free of stress and new, the rest keeps what it carries.
template <int Dim>
void IntegrityChanges<Dim>::heal(const WorkpieceState<Dim>& old, const WorkpieceState<Dim>& now) {
  m_start = old;
  for (std::size_t p = 0; p < now.integrity.size(); ++p) {
    if (!(old.integrity_rate[p] > 0)) continue;
    const double old_part = old.integrity[p] / now.integrity[p];
    for (std::size_t k = 0; k < num_stress<Dim>; ++k) m_start.stress[p * num_stress<Dim> + k] *= old_part;
    for (std::size_t k = 0; k < m_initial.size(); ++k) {
      double& value = m_start.internal[p * m_initial.size() + k];
      value = m_initial[k] + old_part * (value - m_initial[k]);
    }
    m_start.plastic[p] = 0;
  }
}

template class IntegrityChanges<2>;
template class IntegrityChanges<3>;

} // namespace burnish
