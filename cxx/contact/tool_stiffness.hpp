#pragma once
// Stiffness of the tools at a state in balance: how the forces on their coordinates change with the coordinates
// (METHOD.md 3.22).
#include "contact/condensation.hpp"
#include "solver/condensed_solver.hpp"

namespace burnish {

/// A state in balance, with the tangent of the body there.
template <int Dim> struct TangentState {
  const NodeBlockMatrix<Dim>& K; ///< tangent of the body, with its springs, symmetric [force/length]
  const ContactState<Dim>& contact;
  const Eigen::VectorXd &u,
      &R; ///< displacement [length]; internal minus external nodal force [force]; num_dofs
};

/// Keeps pattern and analysis from state to state.
template <int Dim> class ToolStiffness {
public:
  /// Both must outlive it.
  ToolStiffness(const ContactModel<Dim>& model, const BodyView<Dim>& body)
      : m_model(model), m_condensation(model, body) {}
  /// Schur complement of the condensed matrix on the independent coordinates, METHOD.md (3.26): what their forces
  /// Q_k = sum X_k.F change by if a coordinate moves alone, all others held, the contact states as they are. Rows and
  /// columns of coordinates that follow others are zero. One solve per coordinate.
  /// @returns square, one row per coordinate [work over both coordinates]; NaN throughout if the body between held tools
  /// has no stiffness in some direction
  /// @throws std::invalid_argument if K has another size than the body
  Eigen::MatrixXd held(const TangentState<Dim>& state);

private:
  const ContactModel<Dim>& m_model;
  Condensation<Dim> m_condensation;
  CondensedSolver m_solver;
};

/// Stiffness with the coordinates driven as the program does: column l is the change of the forces of all drives when
/// coordinate l is moved, those under motion held, those under force free to follow at their force, METHOD.md (3.27).
/// A coordinate l under force is moved by its drive instead; its formula counts for nothing then. Under force a coordinate
/// that nothing resists stays where it is.
/// @param held of ToolStiffness
/// @param prescribed what is driven by motion and by force, with the formulas of forces; @param q coordinates
/// @returns square [work over both coordinates]; a column is NaN where the free coordinates have no answer: a limit load
template <int Dim>
Eigen::MatrixXd driven_stiffness(const ContactModel<Dim>& model, const Eigen::MatrixXd& held,
                                 const PrescribedValues& prescribed, const Eigen::VectorXd& q);

} // namespace burnish
