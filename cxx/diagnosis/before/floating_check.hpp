#pragma once
// Workpiece and tools that can move together as one rigid body.
#include "contact/contact_setup.hpp"
#include "contact/driving_force.hpp"

namespace burnish {

/// A rigid motion that the supports leave to the workpiece is free if the tools in contact can follow it with
/// coordinates under force, even where every contact node with friction sticks: no equilibrium tells where they are.
/// @throws std::invalid_argument naming tools and coordinates of such a motion
template <int Dim>
void check_not_floating(const ContactSetup<Dim>& setup, const ContactState<Dim>& state,
                        const PrescribedValues& prescribed, const Eigen::VectorXd& u);

} // namespace burnish
