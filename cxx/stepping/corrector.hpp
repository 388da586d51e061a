#pragma once
// The iteration inside a step: residual test, factorization at the predicted state, contact states on the
// dense block, Anderson mixing and halving (algorithms.md section 5). Knows the body only through K and R.
#include "solver/schur_factor.hpp"
#include "stepping/active_set.hpp"
#include "stepping/anderson.hpp"

namespace burnish {

struct CorrectorCounts {
  long iterations = 0, factorizations = 0, solves = 0, analyses = 0, backtracks = 0;
  double factorization_seconds = 0; ///< CPU: sparse factor
  double condensation_seconds = 0;  ///< CPU: flexibility of the window and dense contact blocks
  double solve_seconds = 0;         ///< CPU: back-substitutions
};

template <int Dim> class Corrector {
public:
  /// @param X reference coordinates, num_dofs; @param fixed per dof, 1 where the displacement is given
  /// @throws std::invalid_argument for an empty contact set, wrong sizes, non-finite coordinates
  Corrector(ContactModel<Dim> model, Eigen::VectorXd X, std::vector<char> fixed, StepOptions options = {},
            bool axisymmetric = false);

  const ContactModel<Dim>& model() const { return m_model; }
  const BodyView<Dim>& body() const { return m_body; }
  StepOptions& options() { return m_options; }
  const ContactState<Dim>& state() const { return m_state; }
  ContactState<Dim>& state() { return m_state; }

  /// Starts a step from an accepted state. @param entry per candidate, where a node touching in this step
  /// would stick
  /// @param adapt false: contact states stay fixed (event stepping)
  /// @param keep_factor start with the factor of an earlier step if there is one
  void begin(const Program& program, const ContactState<Dim>& predicted, std::vector<ContactNode<Dim>> entry,
             bool adapt, bool keep_factor = false);
  /// Convergence test at displacement u with residual force R (internal minus external nodal force).
  /// May move u half way back (BACKTRACKED). @throws std::invalid_argument for wrong sizes or NaN in R
  StepStatus check(Eigen::VectorXd& u, const Eigen::VectorXd& R);
  /// Balance of (u, R) at the present states without the test, for steps that are not iterated:
  /// last_balance() and the load scale.
  void measure(const Eigen::VectorXd& u, const Eigen::VectorXd& R);
  /// Factor of the tangent for the steps to come. NOT_POSITIVE_DEFINITE leaves no factor.
  FactorStatus factorize(const NodeBlockMatrix<Dim>& K, const Eigen::VectorXd& u);
  /// Share of the elastic moduli to mix into the next tangent: none at the predicted state, more at every
  /// further factorization of a step (it breaks cycles of plastic points) and after a loss of definiteness.
  double elastic_blend() const;
  bool blend_exhausted() const { return m_indefinite > 3; } ///< the tangent stays indefinite: a limit load
  bool has_factor() const { return m_has_factor; }
  void drop_factor() { m_has_factor = false; }
  /// One iteration: two back-substitutions and the dense contact block; moves u and state().
  StepStatus correct(Eigen::VectorXd& u, const Eigen::VectorXd& R);

  const Balance& last_balance() const { return m_balance; }
  const std::string& reason() const { return m_reason; }
  /// The step failed for a reason outside the corrector. @returns FAILED
  StepStatus give_up(const std::string& why) {
    m_reason = why;
    return StepStatus::FAILED;
  }
  const CorrectorCounts& counts() const { return m_counts; }
  int iteration() const { return m_iteration; }
  /// Load scale of the tolerance: largest contact resultant of the accepted steps and of this one [force].
  double load_scale() const { return m_load_scale; }
  void set_load_scale(double scale) { m_load_scale = scale; }
  const SchurFactor<Dim>& factor() const { return m_factor; }
  /// Extent of the contact of a tool: distance between its outermost contact nodes [length].
  double contact_width(const Eigen::VectorXd& u, int tool) const;

private:
  double balance_at(const Eigen::VectorXd& u, const Eigen::VectorXd& R);
  void choose_window(const Eigen::VectorXd& u);
  bool window_covers(const Eigen::VectorXd& u) const;
  std::vector<int> near_contact(const Eigen::VectorXd& u, double widths, double spacings) const;
  const NodeBlockMatrix<Dim>& shifted(const NodeBlockMatrix<Dim>& K);
  /// Largest residual that counts as balance [force]: the tolerance of the load, or what rounding leaves, but of
  /// that no more than the default tolerance of the load, and a billionth of it in any case.
  double allowed(double scale) const;
  std::string reason_of_failure(double scale) const; // after the last iteration
  Eigen::VectorXd solve(const Eigen::VectorXd& b);
  void project(Eigen::VectorXd& u, bool keep_fresh);
  WindowProblem<Dim> window_problem(const Eigen::VectorXd& u, const Eigen::VectorXd& R,
                                    const Eigen::VectorXd& free_increment);
  Eigen::VectorXd on_window(const Eigen::VectorXd& full) const;
  Eigen::VectorXd scatter_window(const Eigen::VectorXd& window) const;

  ContactModel<Dim> m_model;
  BodyView<Dim> m_body;
  StepOptions m_options;
  Program m_program;
  ContactState<Dim> m_state;
  std::vector<ContactNode<Dim>> m_entry;
  bool m_adapt = true;

  SchurFactor<Dim> m_factor;
  bool m_has_factor = false, m_keep_factor = false;
  std::vector<int> m_window;
  Eigen::MatrixXd m_flexibility;
  bool m_floating = false; // the supports leave a rigid motion free: the factor is that of a shifted tangent
  NodeBlockMatrix<Dim> m_shifted;
  Eigen::VectorXd m_shift; // Dim*window

  AndersonMixer m_mixer;
  Balance m_balance;
  CorrectorCounts m_counts;
  std::string m_reason;
  double m_rounding = 0; // residual that rounding leaves, of the last tangent [force]
  double m_load_scale = 0, m_last_residual = -1, m_best_residual = -1;
  int m_iteration = 0, m_backtracks = 0, m_step_factorizations = 0, m_indefinite = 0;
  Eigen::VectorXd m_u_before, m_q_before; // iterate before the last correct(), for halving
  std::vector<char> m_fresh;
  std::vector<int> m_releases; // per candidate, in this step
};

} // namespace burnish
