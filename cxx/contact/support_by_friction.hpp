#pragma once
// What friction holds while the states of a window are looked for: tools under force, and the body between tools (ALGORITHMS.md 5.3).
#include "contact/window_solver.hpp"

namespace burnish {

/// Of one window: which nodes stick on trial, and how often that has been tried.
template <int Dim> class SupportByFriction {
public:
  /// @param problem must outlive it
  explicit SupportByFriction(const WindowProblem<Dim>& problem);
  /// Before a pass: a node sticks where nothing else holds a tool (stick_unsupported) or the body (stick_at_neutral_point).
  void begin_pass(const WindowSolver<Dim>& solver, ContactState<Dim>& trial);
  /// The block of a pass has no solution. @returns whether another node sticks now, and the pass may be tried again
  bool regain(ContactState<Dim>& trial);
  /// States have been there before, and nothing sticks to what holds the body: the node that slips least sticks instead of the changes
  /// chosen, if the states then contradict their forces in no more nodes.
  /// @param before the states of the pass @param left its contradictions @param trial the states chosen next; changed
  void leave_cycle(const WindowSolver<Dim>& solver, const ContactState<Dim>& before, int left,
                   ContactState<Dim>& trial);
  /// After a pass: nodes that could not stick are the last to do so again.
  void note_refused(const ContactState<Dim>& before, const ContactState<Dim>& after);
  /// Whether only tools hold the body, and no node sticks to them.
  bool is_lost(const ContactState<Dim>& state) const;

private:
  const WindowProblem<Dim>& m_problem;
  const ContactModel<Dim>& m_model;
  std::vector<char> m_refused; // candidates that could not stick
  bool m_floating;             // only tools hold the body
  std::vector<char> m_idle;    // tools that friction holds, and that hold nothing by it
  int m_trials = 0, m_supports = 0, m_losses = 0, m_cycles = 0;
};

} // namespace burnish
