#pragma once
// The dense nonsymmetric contact block: W' S A + Geo on the active nodes, S the Schur complement of the body
// on them (method.md section 3 and 5; article eq. 1.13-1.21 after eliminating all other nodes).
#include "contact/linearization.hpp"

namespace burnish {

/// Active contact nodes in the order of their linearizations.
template <int Dim> struct ContactBlockInput {
  const std::vector<NodeLinearization<Dim>>* nodes = nullptr;
  const Eigen::MatrixXd* flexibility = nullptr; ///< C_aa = (K^-1)_aa, Dim*active square [length/force]
  Eigen::VectorXd
      free_increment; ///< (K^-1(-R))_a: increment of the active nodes without any contact force, Dim*active
  Eigen::VectorXd offset; ///< X(q,s) - x of the active nodes, Dim*active [length]
  /// Stiffness that was added to the body's tangent on the diagonal of active (or loose) nodes before
  /// `flexibility` and `free_increment` were made, and is taken off again here, exactly: a body that only its
  /// tools hold has a singular tangent. Dim*active [force/length], or empty: none.
  Eigen::VectorXd shift;
};

template <int Dim> struct ContactBlockSolution {
  bool singular = false;
  int weakest_coordinate = -1; ///< if singular: coordinate that nothing resists, or -1
  Eigen::VectorXd ds;          ///< per active node (0 for sticking ones), times one parameter
  Eigen::VectorXd dq;          ///< all coordinates
  Eigen::VectorXd load;        ///< F plus what the shift carries: the load for the shifted tangent [force]
  Eigen::VectorXd F;           ///< total contact force on the active nodes, Dim*active [force]
};

/// Solves for slips, coordinates and contact forces at fixed states.
/// Equations: sliding node tau.F + constant + Geo = 0; coordinate under force sum X_k.F + Geo = Q_k; under
/// motion dq_k = value - q_k; force F = S (offset + A z - free_increment).
template <int Dim>
ContactBlockSolution<Dim> solve_contact_block(const ContactModel<Dim>& model, const Program& program,
                                              const Eigen::VectorXd& q, const ContactBlockInput<Dim>& input);

} // namespace burnish
