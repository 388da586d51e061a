#pragma once
// Moves the iterate of a step by solutions of the condensed system, whosever solver has found them (ALGORITHMS.md 5.8).
#include "contact/condensation.hpp"
#include "contact/pass_choice.hpp"
#include "iteration/iteration.hpp"
#include <optional>

namespace burnish {

template <int Dim> class CondensedIteration {
public:
  /// @param iteration must outlive it
  explicit CondensedIteration(Iteration<Dim>& iteration);
  void begin(); ///< a step
  /// Before a condensed system is made: a tool that only friction supports gets a sticking node, as in solve_window.
  void prepare();
  /// Tools that friction alone holds, of held_by_friction; empty in the plane and where states are fixed.
  const std::vector<char>& by_friction() const { return m_by_friction; }
  /// One iteration by the solution of the condensed system. The states of the candidates are tested with the forces that the
  /// solution predicts, unless they are fixed: where some change, nothing moves and again() is true until the system has been
  /// condensed and solved anew, at the same u and R. Else u and the state move.
  void advance(const typename Condensation<Dim>::Expansion& increment, Eigen::VectorXd& u);
  bool again() const { return m_again; }
  /// No states have been found that agree with their forces, three iterations in a row: the step has failed.
  bool gave_up() const { return m_gave_up; }

private:
  void begin_passes();
  int change_states(const typename Condensation<Dim>::Expansion& increment, const Eigen::VectorXd& u);

  Iteration<Dim>& m_iteration;
  std::vector<int> m_candidates; // all of them
  bool m_again = false, m_gave_up = false;
  int m_passes = 0, m_supports = 0; // changes of states, and nodes made to stick, since u has moved
  std::optional<PassChoice<Dim>> m_choice;
  std::vector<char> m_refused; // nodes that could not stick since then
  std::vector<char> m_by_friction, m_turning;
};

} // namespace burnish
