#pragma once
// Motions of tools that no contact resists (METHOD.md 5.5).
#include "contact/contact_setup.hpp"
#include "contact/driving_force.hpp"

namespace burnish {

/// Coordinates under force of a frictionless tool that moves by them along its surface: in the plane one by one, in space any
/// combination of them, judged by the rank of the normal motions of the contact nodes and their neighbors. As many as there
/// are such motions are fixed where they are. @returns their names, for reports
/// @throws std::invalid_argument where the forces have work in such a motion, beyond rounding
template <int Dim>
std::vector<std::string> leave_out_unresisted(const ContactSetup<Dim>& setup, const ContactState<Dim>& state,
                                              const Eigen::VectorXd& u, PrescribedValues& prescribed);

} // namespace burnish
