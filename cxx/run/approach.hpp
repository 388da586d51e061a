#pragma once
// A tool is moved along one of its coordinates until it just touches the body.
#include "contact/contact_setup.hpp"

namespace burnish {

/// Newton's method on the smallest gap as a function of coordinate k of the tool; while that gap is
/// parallel to the motion, or opens, the tool goes on to the first touch of other nodes.
/// @param state before: all tools at state.q; @param u displacement of the body
/// @returns the state with the tool moved and the touching nodes in contact
/// @throws std::invalid_argument if it cannot touch by this coordinate alone, would touch from inside or come
/// out behind a body that lay wholly inside it, if it follows others, or another coordinate of the tool follows it
template <int Dim>
ContactState<Dim> approached(const ContactSetup<Dim>& setup, ContactState<Dim> state,
                             const Eigen::VectorXd& u, int tool, int k);

/// A body that its supports do not hold is held by the tools that it stands on from the start: nodes whose gap counts as
/// touch, or is less, come into contact.
/// @param u displacement of the body, num_dofs; @param state all tools at state.q
template <int Dim>
void touch_in_place(const ContactSetup<Dim>& setup, const Eigen::VectorXd& u, ContactState<Dim>& state);

} // namespace burnish
