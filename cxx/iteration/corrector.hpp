#pragma once
// Moves the iterate of a step by a factored tangent: factorization at the predicted state, contact states on the dense block,
// Anderson mixing (ALGORITHMS.md 5).
#include "iteration/anderson.hpp"
#include "iteration/factored_tangent.hpp"
#include "iteration/iteration.hpp"
#include <functional>

namespace burnish {

/// What serves the steps to come. Plain data, but for the factor that is shared.
template <int Dim> struct FactorMemory {
  std::vector<int> window;
  std::shared_ptr<FactoredTangent<Dim>> tangent; ///< null: none; without a solver: to be factored again
  int age = 0;                                   ///< steps accepted since it was made
};

template <int Dim> class Corrector {
public:
  /// @param iteration must outlive it
  explicit Corrector(Iteration<Dim>& iteration);

  /// A step begins. @param keep_factor it starts with the factor of an earlier one if there is one
  void begin(bool keep_factor);
  /// Whether there is a factor for the iterate, whose window covers the contact.
  bool serves(const Eigen::VectorXd& u) const;
  /// Factor of the tangent for the iterations to come. NOT_POSITIVE_DEFINITE leaves no factor.
  /// @param K what is moved here is freed before the factor is made
  FactorStatus factorize(NodeBlockMatrix<Dim> K, const Eigen::VectorXd& u);
  /// One iteration: two back-substitutions and the dense contact block; moves u and the state.
  StepStatus correct(Eigen::VectorXd& u, const Eigen::VectorXd& R);
  void drop_factor() { m_has_factor = false; }
  bool has_factor() const { return m_has_factor; }
  /// Of a tangent that another one solves with: takes what rounding leaves of its forces, and drops the factor.
  void measure(const NodeBlockMatrix<Dim>& K);
  /// From now on factors serve steps to come: their matrices are kept, so that a run can go on from a file.
  void keep_matrices() { m_keeps_matrices = true; }
  /// Whose solver factors the tangents to come; empty: SchurFactor. The factor that there is is dropped.
  void set_solver(std::function<std::unique_ptr<BodySolver<Dim>>()> make);
  bool own_solver() const { return !m_make_solver; } ///< the core's
  /// Ends the mixing, whose vectors need not lie beside a tangent that is assembled.
  void forget_mixing() { m_mixer.clear(); }
  /// The step is accepted: the factor is a step older.
  void accepted() { ++m_age; }
  int factor_age() const { return m_age; }
  FactorMemory<Dim> memory() const { return {m_window, m_has_factor ? m_tangent : nullptr, m_age}; }
  void restore(const FactorMemory<Dim>& memory);
  /// Largest displacement of a contact node by a unit force on it, of the last factor; 0 without one [length/force].
  double compliance() const;

private:
  std::vector<int> new_window(const Eigen::VectorXd& u) const;
  void take_flexibility();
  void make_tangent(int num_nodes);
  std::unique_ptr<BodySolver<Dim>> make_solver(bool by_columns) const;
  FactorStatus factorize_held(const NodeBlockMatrix<Dim>& K, const Eigen::VectorXd& u);
  Failure singular(const WindowSolution<Dim>& solution, const WindowProblem<Dim>& problem);
  WindowProblem<Dim> window_problem(const Eigen::VectorXd& u, const Eigen::VectorXd& R,
                                    const SweptLoad& load);
  SweptLoad sweep(const Eigen::VectorXd& b);
  Eigen::VectorXd displacement(const SweptLoad& load, const Eigen::VectorXd& p);

  Iteration<Dim>& m_iteration;
  bool m_floating; // the supports leave a rigid motion free
  std::function<std::unique_ptr<BodySolver<Dim>>()> m_make_solver;
  std::shared_ptr<FactoredTangent<Dim>> m_tangent;
  ActivePart m_flexibility; // of m_tangent, on the active nodes
  bool m_has_factor = false, m_keep_factor = false, m_keeps_matrices = false;
  bool m_indefinite =
      false; // a factor of this step has turned out so by its flexibility; the solver did not tell
  int m_age = 0;
  std::vector<int> m_window;
  AndersonMixer m_mixer;
};

} // namespace burnish
