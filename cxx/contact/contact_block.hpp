#pragma once
// The dense nonsymmetric contact block: W' S A + Geo on the active nodes, S the Schur complement of the body
// on them (METHOD.md 3.4, ALGORITHMS.md 8.4).
#include "contact/linearization.hpp"
#include "solver/active_part.hpp"

namespace burnish {

/// The nodes that the block is made of, in the order of their linearizations. Given components of constrained nodes
/// take no part: they are eliminated.
template <int Dim> struct ContactBlockInput {
  const std::vector<NodeLinearization<Dim>>* nodes = nullptr;
  /// Free components of the nodes: their places among the Dim*nodes components of this block, ascending.
  const std::vector<int>* free = nullptr;
  /// C = K^-1 on the free components, current (ActivePart::select) [length/force].
  const ActivePart* flexibility = nullptr;
  /// (K^-1(-R)): increment of the nodes without any contact force, Dim*nodes [length]
  Eigen::VectorXd free_increment;
  Eigen::VectorXd offset; ///< X(q,y) - x of the nodes, Dim*nodes [length]
  /// Stiffness that was added to the body's tangent on the diagonal of nodes in contact or beside it before
  /// `flexibility` and `free_increment` were made, and is taken off again here, exactly: a body that only its
  /// tools support has a singular tangent. Dim*nodes [force/length], or empty: none.
  Eigen::VectorXd added_stiffness;
  bool test_stability = false; ///< find out whether body and tools are stable together
};

template <int Dim> struct ContactBlockSolution {
  bool singular = false;
  bool unstable = false; ///< if tested: the body, its tools where they are, is not stable (METHOD.md 5.6)
  int weakest_coordinate = -1; ///< if singular: coordinate that nothing resists, or -1
  Eigen::MatrixXd slip;        ///< Dim-1 x nodes, in the tangents E (0 for sticking ones) [length]
  Eigen::VectorXd dq;          ///< all coordinates
  Eigen::VectorXd
      load;          ///< F plus what the added stiffness carries: the load of the factor, Dim*nodes [force]
  Eigen::VectorXd F; ///< total contact force on the nodes, Dim*nodes [force]
};

/// Solves for slips, coordinates and contact forces at fixed states.
/// Equations: sliding node W'F + constant + Geo = 0; coordinate under force sum X_k.F + Geo = Q_k; under
/// motion dq_k = value - q_k; force F = S (offset + A z - free_increment).
template <int Dim>
ContactBlockSolution<Dim> solve_contact_block(const ContactModel<Dim>& model,
                                              const PrescribedValues& prescribed, const Eigen::VectorXd& q,
                                              const ContactBlockInput<Dim>& input);

} // namespace burnish
