#pragma once
// Motions of a tool that the nodes in contact do not see (METHOD.md 5.5): the spin of a ball on one node.
#include "contact/contact_model.hpp"

namespace burnish {

/// Coordinates under force, with no force of their own, that take part in a motion of their tool that neither moves it along the
/// normal of a node in contact nor, at a node with friction, moves it at all. One for each such motion: the one that moves the
/// tool most in it; it keeps the place that is predicted for it until more nodes touch. In the plane none: there the first node
/// with friction resists every turn of a smooth tool. Not those held by a coupling or by what follows them.
/// @param state states of the nodes, coordinates q @returns their numbers
template <int Dim>
std::vector<int> idle_combinations(const ContactModel<Dim>& model, const PrescribedValues& prescribed,
                                   const ContactState<Dim>& state);

/// Prescriptions in which all idle coordinates, of tools that touch nothing and those above, are under motion.
/// @param resting coordinates of all tools: where the idle ones stay, wherever an iteration with fewer nodes has taken them
template <int Dim>
PrescribedValues with_idle_given(const ContactModel<Dim>& model, const PrescribedValues& prescribed,
                                 const ContactState<Dim>& state, const Eigen::VectorXd& resting);

} // namespace burnish
