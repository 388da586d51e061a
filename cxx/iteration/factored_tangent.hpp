#pragma once
// A factored tangent of the body with what the dense contact block needs of it.
#include "contact/body_view.hpp"
#include "contact/contact_model.hpp"
#include "solver/body_solver.hpp"
#include <memory>

namespace burnish {

/// Candidates far from one another in the reference body, Dim of them at most, ascending: they hold it where its supports leave it a
/// rigid motion, however narrow the window around its contacts.
template <int Dim> std::vector<int> far_candidates(const ContactModel<Dim>& model, const BodyView<Dim>& body);

template <int Dim> struct FactoredTangent {
  std::unique_ptr<BodySolver<Dim>> solver;
  bool by_columns = false; ///< the core's solver is a ColumnFactor, see ALGORITHMS.md 8.2
  std::vector<int> window; ///< candidates on the dense block, ascending
  std::shared_ptr<const Eigen::MatrixXd>
      flexibility;                 ///< of the window, BodySolver::candidate_flexibility [length/force]
  Eigen::VectorXd added_stiffness; ///< Dim*window, see ContactBlockInput; empty: none [force/length]
  double slip_stiffness = 0;       ///< of ContactState, while the factor serves [force/length]
  NodeBlockMatrix<Dim>
      matrix; ///< that was factored, where steps to come may use the factor; else of no nodes
  std::vector<std::vector<int>> solved; ///< of a factor to be made again: BodySolver::solved_columns

  /// Factor of K for this window, see BodySolver::factorize.
  /// @param stiffen the supports leave a rigid motion free, or the body is not stable without its tools: stiffness is
  ///        added to the diagonal of the contact nodes and of far_candidates in the window, which the dense block takes off
  ///        again
  FactorStatus factorize(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                         const ContactState<Dim>& state, NodeBlockMatrix<Dim> K, bool stiffen);
  /// Factor of `matrix` again by a new solver, with all that was known of it.
  void factorize_again(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                       std::unique_ptr<BodySolver<Dim>> by);
  /// Reads the flexibility out of the factor.
  void condense();
};

} // namespace burnish
