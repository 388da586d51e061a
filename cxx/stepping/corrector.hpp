#pragma once
// The iteration inside a step: residual test, factorization at the predicted state, contact states on the
// dense block, Anderson mixing and backtracking (ALGORITHMS.md 5). Knows the body only through K and R.
#include "contact/active_set.hpp"
#include "contact/balance.hpp"
#include "contact/condensation.hpp"
#include "stepping/anderson.hpp"
#include "stepping/convergence_rate.hpp"
#include "stepping/factored_tangent.hpp"
#include "stepping/options.hpp"

namespace burnish {

struct CorrectorCounts {
  long iterations = 0, factorizations = 0, solves = 0, analyses = 0, backtracks = 0, condensations = 0;
  long factor_entries = 0;          ///< numbers stored in the last factor
  double factorization_seconds = 0; ///< CPU: sparse factor
  double condensation_seconds = 0;  ///< CPU: flexibility of the window and dense contact blocks
  double solve_seconds = 0;         ///< CPU: back-substitutions
};

/// What the iteration carries from step to step.
template <int Dim> struct CorrectorMemory {
  double load_scale = 0; ///< load of the tolerance: largest contact resultant of the accepted steps [force]
  Eigen::VectorXd tool_load; ///< the same of every tool alone; empty: none yet [force]
  double rounding = 0;       ///< residual that rounding leaves, of the last tangent [force]
  std::vector<int> window;
  std::shared_ptr<FactoredTangent<Dim>> tangent; ///< the factor that serves the next step, or null
  int factor_age = 0;                            ///< steps accepted since it was made
};

template <int Dim> class Corrector {
public:
  /// @param model, body must outlive it; @throws std::invalid_argument for an empty contact set or no tool
  Corrector(const ContactModel<Dim>& model, const BodyView<Dim>& body, StepOptions options);

  StepOptions& options() { return m_options; }
  const StepOptions& options() const { return m_options; }
  const ContactState<Dim>& state() const { return m_state; }
  ContactState<Dim>& state() { return m_state; }

  /// Starts a step from a predicted state. @param entry per candidate, where a node touching in this step
  /// would stick
  /// @param adapt false: contact states stay fixed (event stepping)
  /// @param keep_factor start with the factor of an earlier step if there is one
  void begin(const PrescribedValues& prescribed, const ContactState<Dim>& predicted,
             std::vector<ContactNode<Dim>> entry, bool adapt, bool keep_factor = false);
  /// Convergence test at displacement u with residual force R (internal minus external nodal force).
  /// May move u half way back (BACKTRACKED). @throws std::invalid_argument for wrong sizes or NaN in R
  StepStatus check(Eigen::VectorXd& u, const Eigen::VectorXd& R);
  /// Balance of (u, R) at the present states without the test, for steps that are not iterated:
  /// last_balance() and the load scale.
  void measure(const Eigen::VectorXd& u, const Eigen::VectorXd& R);
  /// Factor of the tangent for the steps to come. NOT_POSITIVE_DEFINITE leaves no factor.
  FactorStatus factorize(const NodeBlockMatrix<Dim>& K, const Eigen::VectorXd& u);
  /// Part of elastic moduli to mix into the next tangent: none at the predicted state, more at every
  /// further factorization of a step (it breaks cycles of plastic points) and after a loss of definiteness.
  double elastic_blend() const;
  /// The tangent stays indefinite: a limit load.
  bool blend_exhausted() const { return m_indefinite > m_options.max_indefinite; }
  void drop_factor() { m_has_factor = false; }
  /// Before a tangent is assembled: its factor ends the mixing, whose vectors need not lie beside it.
  void forget_mixing() { m_mixer.clear(); }
  /// The step is accepted: the factor is a step older.
  void accepted() { ++m_factor_age; }
  int factor_age() const { return m_factor_age; }
  /// One iteration: two back-substitutions and the dense contact block; moves u and state().
  StepStatus correct(Eigen::VectorXd& u, const Eigen::VectorXd& R);

  /// Before a condensed system is made: a tool that only friction supports gets a sticking node.
  void prepare_condensed();
  /// One iteration by the solution of the condensed system instead of factorize and correct. The states of the candidates
  /// are tested with the forces that the solution predicts, unless they are fixed: where some change, nothing moves and
  /// again() is true until the system has been condensed and solved anew, at the same u and R. Else u and state() move.
  void advance(const typename Condensation<Dim>::Expansion& increment, Eigen::VectorXd& u);
  bool again() const { return m_again; }

  CorrectorMemory<Dim> memory() const;
  void restore(const CorrectorMemory<Dim>& memory);
  const Balance& last_balance() const { return m_balance; }
  const std::string& reason() const { return m_reason; }
  /// The step failed for a reason outside the corrector. @returns FAILED
  StepStatus give_up(const std::string& why) {
    m_reason = why;
    return StepStatus::FAILED;
  }
  const CorrectorCounts& counts() const { return m_counts; }
  void count_condensation() { ++m_counts.condensations; }
  void set_counts(const CorrectorCounts& counts) { m_counts = counts; }
  int iteration() const { return m_iteration; }
  /// Load scale of the tolerance: largest contact resultant of the accepted steps and of this one [force].
  double load_scale() const { return m_load_scale; }
  void set_load_scale(double scale, const Eigen::VectorXd& tools) {
    m_load_scale = scale;
    m_tool_load = tools;
  }
  /// What belongs to a tool is held to this [force], one per tool, no more than the tolerance of all (ALGORITHMS.md 5.1).
  Eigen::VectorXd tool_tolerance() const;
  /// Largest displacement of a contact node by a unit force on it, of the last factor; 0 without one [length/force].
  double compliance() const;
  /// Increment of the coordinates by the first iteration of this step; empty before. For the test of jumps.
  const Eigen::VectorXd& first_increment() const { return m_first_dq; }
  /// What a soft hold carries: a load as supports have it [force].
  void set_held(double force) { m_held = force; }

private:
  static constexpr const char* UNSTABLE =
      "the tangent is not positive definite: loss of stability or limit load";
  double balance_at(const Eigen::VectorXd& u, const Eigen::VectorXd& R);
  bool window_covers(const Eigen::VectorXd& u) const;
  StepStatus backtrack(Eigen::VectorXd& u);
  std::string singular_reason(const WindowSolution<Dim>& solution) const;
  /// Largest residual that counts as balance [force]: the tolerance of the load, or what rounding leaves, but of
  /// that no more than the default tolerance of the load, and a billionth of it in any case.
  double allowed(double scale) const;
  Eigen::VectorXd allowed_of_tools(double scale, const Eigen::VectorXd& tools) const;
  FactorStatus factorize_held(const NodeBlockMatrix<Dim>& K, const Eigen::VectorXd& u);
  std::string reason_of_failure(double scale) const; // after the last iteration
  ActiveSetOptions active_set_options() const;
  SweptLoad sweep(const Eigen::VectorXd& b);
  Eigen::VectorXd displacement(const SweptLoad& load, const Eigen::VectorXd& p);
  void project(Eigen::VectorXd& u, bool keep_fresh);
  WindowProblem<Dim> window_problem(const Eigen::VectorXd& u, const Eigen::VectorXd& R,
                                    const SweptLoad& load);

  const ContactModel<Dim>& m_model;
  const BodyView<Dim>& m_body;
  StepOptions m_options;
  bool m_floating; // the supports leave a rigid motion free
  PrescribedValues m_prescribed;
  ContactState<Dim> m_state;
  EntryPlaces<Dim> m_entry;
  bool m_adapt = true;

  std::shared_ptr<FactoredTangent<Dim>> m_tangent;
  ActiveCholesky m_flexibility; // of m_tangent, on the active nodes
  bool m_has_factor = false, m_keep_factor = false;
  bool m_condensed = false, m_again = false; // iterations of this step come from the condensed system
  std::vector<int> m_window;

  AndersonMixer m_mixer;
  ConvergenceRate m_rate;
  Balance m_balance;
  CorrectorCounts m_counts;
  std::string m_reason;
  double m_rounding = 0, m_load_scale = 0, m_last_residual = -1, m_held = 0;
  int m_factor_age = 0, m_iteration = 0, m_backtracks = 0, m_step_factorizations = 0, m_indefinite = 0;
  Eigen::VectorXd m_u_before, m_q_before;       // iterate before the last iteration, for backtracking
  Eigen::VectorXd m_tool_load, m_first_dq, m_R; // m_R: of the last check
  std::vector<char> m_fresh;
  // of the condensed iterations
  bool change_states(const typename Condensation<Dim>::Expansion& increment, const Eigen::VectorXd& u);
  void choose_blend(double residual);
  int m_falls = 0;             // iterations in a row that made the residual smaller
  int m_passes = 0;            // changes of states since u has moved
  std::vector<char> m_refused; // nodes that could not stick since then
  std::vector<ContactNode<Dim>> m_nodes_before;
};

} // namespace burnish
