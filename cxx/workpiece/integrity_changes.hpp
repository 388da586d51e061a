#pragma once
// Damage and healing in a step: how the integrities of points go on, and what healing leaves of the start (METHOD.md 1.12).
#include "workpiece/workpiece_state.hpp"

namespace burnish {

template <int Dim> class IntegrityChanges {
public:
  /// @param initial internal variables of a point in the undeformed body
  explicit IntegrityChanges(std::vector<double> initial) : m_initial(std::move(initial)) {}
  /// @throws std::invalid_argument if < 0 or not finite
  void set_step_length(double length);
  /// Integrities of `now` at the end of a step, or of a part of one, of the length now.dt that starts at `old`.
  void move(const WorkpieceState<Dim>& old, WorkpieceState<Dim>& now);
  /// That start, as healing leaves it.
  const WorkpieceState<Dim>& start(const WorkpieceState<Dim>& old) const { return m_healing ? m_start : old; }

private:
  void heal(const WorkpieceState<Dim>& old, const WorkpieceState<Dim>& now);

  std::vector<double> m_initial;
  double m_step_length = 0; // of a full step [time]; 0: every one is
  bool m_healing = false;
  WorkpieceState<Dim> m_start; // while m_healing
};

} // namespace burnish
