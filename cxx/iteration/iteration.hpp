#pragma once
// The iterate of a step: contact states, convergence test, steps back (ALGORITHMS.md 5). It knows the body only by the nodal
// forces; what moves it is a Corrector, or a CondensedIteration.
#include "contact/active_set.hpp"
#include "iteration/failure.hpp"
#include "iteration/step_balance.hpp"
#include "iteration/tangent_policy.hpp"
#include "iteration/way_back.hpp"

namespace burnish {

struct IterationCounts {
  long iterations = 0, factorizations = 0, solves = 0, analyses = 0, backtracks = 0, condensations = 0;
  long factor_entries = 0;          ///< numbers stored in the last factor
  double factorization_seconds = 0; ///< CPU: sparse factor
  double condensation_seconds = 0;  ///< CPU: flexibility of the window and dense contact blocks
  double solve_seconds = 0;         ///< CPU: back-substitutions
};

template <int Dim> class Iteration {
public:
  /// @param model, body must outlive it; @throws std::invalid_argument for an empty contact set or no tool
  Iteration(const ContactModel<Dim>& model, const BodyView<Dim>& body, IterationOptions options);

  IterationOptions& options() { return m_options; }
  const IterationOptions& options() const { return m_options; }
  const ContactModel<Dim>& model() const { return m_model; }
  const BodyView<Dim>& body() const { return m_body; }

  /// Starts a step from a predicted state. @param entry where candidates are at its start
  /// @param adapt false: contact states stay fixed (event stepping)
  void begin(const PrescribedValues& prescribed, const ContactState<Dim>& predicted, EntryPlaces<Dim> entry,
             bool adapt);
  /// Convergence test at displacement u with residual force R (internal minus external nodal force). May move u part of
  /// the way back (BACKTRACKED). @returns REFACTORIZE where the convergence asks for a new tangent, and after a way back
  /// @throws std::invalid_argument for wrong sizes or NaN in R
  StepStatus check(Eigen::VectorXd& u, const Eigen::VectorXd& R);
  /// Before the first iteration, where the window has no solution: whether nothing asks for one. Forces and states are in order and
  /// coordinates under motion have arrived, so that what nothing holds stays where it is; the next check() takes the state.
  bool rests();
  /// A window has been solved. @param contradictions states that contradict the forces of its solution
  /// @returns FAILED after three windows in a row without a solution: such iterates lead nowhere
  StepStatus solved(int contradictions);
  /// An iteration begins to move u and the state. @param dq increment of the coordinates that it has found
  void leave(const Eigen::VectorXd& u, const Eigen::VectorXd& dq);
  /// It has moved them: contact nodes find their places on the tools.
  void arrive(const Eigen::VectorXd& u);
  /// The step failed for a reason outside of the convergence test. @returns FAILED
  StepStatus give_up(const Failure& why);
  const Failure& failure() const { return m_failure; }

  ContactState<Dim>& state() { return m_state; }
  const ContactState<Dim>& state() const { return m_state; }
  const PrescribedValues& prescribed() const { return m_prescribed; }
  /// Puts the states to be tested into a problem: model, body, prescriptions, start, places, tolerances.
  void state_problem(WindowProblem<Dim>& problem);
  StepBalance<Dim>& balance() { return m_balance; }
  const StepBalance<Dim>& balance() const { return m_balance; }
  TangentPolicy& policy() { return m_policy; }
  IterationCounts& counts() { return m_counts; }
  const IterationCounts& counts() const { return m_counts; }
  int number() const { return m_number; } ///< iterations made in this step
  /// Increment of the coordinates by the first iteration of this step; empty before. For the test of jumps.
  const Eigen::VectorXd& first_increment() const { return m_first_dq; }

private:
  bool searches() const;
  bool went_too_far(Eigen::VectorXd& u, const Eigen::VectorXd& R);
  void find_places(const Eigen::VectorXd& u);
  Failure not_converged() const;

  const ContactModel<Dim>& m_model;
  const BodyView<Dim>& m_body;
  IterationOptions m_options;
  PrescribedValues m_prescribed;
  ContactState<Dim> m_state;
  EntryPlaces<Dim> m_entry;
  bool m_adapt = true;
  StepBalance<Dim> m_balance;
  TangentPolicy m_policy;
  IterationCounts m_counts;
  Failure m_failure;
  int m_number = 0, m_unsolved = 0, m_half_ways = 0;
  WayBack m_way_back;
  Eigen::VectorXd m_predicted_q, m_first_dq, m_R; // m_R: of the last check
};

} // namespace burnish
