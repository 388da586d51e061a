#pragma once
// The direction of slip in space, which turns with slip and force: the cone form of METHOD.md 3.12.
#include "contact/tied_edges.hpp"
#include "solver/node_block_matrix.hpp"

namespace burnish {

/// Number c of METHOD.md (3.14) for a tangent K: a part of the median of the candidates' own stiffness; 0 in the plane,
/// where nothing turns [force/length].
template <int Dim> double slip_stiffness(const ContactModel<Dim>& model, const NodeBlockMatrix<Dim>& K);

/// Refers to what begin_turn looks at.
template <int Dim> struct BeginningSlips {
  const std::vector<char>&
      by_friction; ///< tools, of held_by_friction, all of a body between tools; empty: none
  const ContactState<Dim>& state;
  const std::vector<Pose<Dim>>& poses;             ///< of its tools
  const std::vector<DecidingForce<Dim>>& deciding; ///< of its candidates
};

/// Lets the slip of a node, or of the ends that it is tied to, turn that begins to slide on a tool which friction alone holds, METHOD.md
/// (3.14d). What its forces do not press does not turn.
/// @param cones in: of cones_of, with no turn yet
template <int Dim>
void begin_turn(const ContactModel<Dim>& model, const BeginningSlips<Dim>& slips, int candidate,
                NodeCones<Dim>& cones);

/// Directions of the nodes that slide by METHOD.md (3.14), from their slips and the forces on them: m along c D - T. Guided nodes keep
/// the part that their supports leave; those that have slipped against their direction keep it where states may change, those with g <= 0
/// where they are fixed; in the plane all do.
/// @param R internal minus external nodal force, num_dofs [force]
template <int Dim>
void turn_slips(const ContactModel<Dim>& model, const Eigen::VectorXd& R, ContactState<Dim>& state);

/// What the direction m of a sliding node is off its slip D, as a force: METHOD.md (3.14f). Zero in the plane, and of a node that has
/// slipped against m, which is to stick. @param c of METHOD.md (3.14) [force/length] @returns [force]
template <int Dim>
double direction_residual(const TangentialLaw<Dim>& law, const DecidingForce<Dim>& deciding,
                          const Param<Dim>& m, const Param<Dim>& slip, double c);

} // namespace burnish
