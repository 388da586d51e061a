#pragma once
// Edges of quadratic elements in contact with friction: stick and slip are decided at the corners, by forces that the mid
// nodes share with them, and a mid node is tied to the slips of its ends (METHOD.md 3.19).
#include "contact/friction_tangent.hpp"
#include "contact/linearization.hpp"

namespace burnish {

/// Ties every mid node that touches, with friction, the same tool as both ends of its edge; unties all others. In the plane
/// one end has to stick: one that was tied while both ends have begun to slide slides with the first of them. In space all
/// three have to have touched that tool before the step; a vertex without friction takes up the state of its tied mid nodes.
/// @param before states at the start of the step
/// @param state  states of a step before its iteration; places of mid nodes stay, see follow_ends
template <int Dim>
void tie_edges(const ContactModel<Dim>& model, const std::vector<ContactNode<Dim>>& before,
               ContactState<Dim>& state);

/// The same between events: a tie goes on while the three touch the tool, and one begins where no force jumps, so that nothing
/// else happens at that instant.
template <int Dim> void keep_ties(const ContactModel<Dim>& model, ContactState<Dim>& state);

/// Tied mid nodes take state and place from their ends: they stick at their slip_origin if both do, else they slide by half
/// the sum of their slips. A tie is dropped where the mid node or an end is not in contact any more, or on another tool; the
/// node goes on alone, as it is, and a weightless vertex that has lost its last tie slides without friction.
template <int Dim> void follow_ends(const ContactModel<Dim>& model, ContactState<Dim>& state);

/// Deciding forces of all candidates; zero for those not in contact. A tied node keeps its own, which decide nothing but its release.
/// @param own forces on the candidates in the frames of their surface points [force]
template <int Dim>
std::vector<DecidingForce<Dim>>
deciding_forces(const ContactModel<Dim>& model, const ContactState<Dim>& state,
                const std::vector<Pose<Dim>>& poses, const std::vector<SurfaceForce<Dim>>& own);
/// The same at the poses of the tools. @param R internal minus external nodal force, num_dofs [force]
template <int Dim>
std::vector<DecidingForce<Dim>>
deciding_forces(const ContactModel<Dim>& model, const ContactState<Dim>& state,
                const std::vector<Pose<Dim>>& poses, const Eigen::VectorXd& R);

/// Cones for linearize_node, as the tangent sees them.
template <int Dim>
NodeCones<Dim> cones_of(const ContactModel<Dim>& model, const ContactState<Dim>& state,
                        const std::vector<Pose<Dim>>& poses, const std::vector<DecidingForce<Dim>>& deciding,
                        int candidate, FrictionTangent tangent = FrictionTangent::CONSISTENT);

} // namespace burnish
