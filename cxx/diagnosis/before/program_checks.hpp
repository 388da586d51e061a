#pragma once
// What is checked of a program and of the tools' places before a step.
#include "contact/contact_setup.hpp"
#include "contact/driving_force.hpp"
#include "mesh/mesh_locator.hpp"

namespace burnish {

/// Values that the tools' prescriptions hold for the end of a step at t. @throws std::invalid_argument naming a coordinate without any
template <int Dim> PrescribedValues prescribed_values(const ContactSetup<Dim>& setup, double t);

/// Between steps a tool moves by its program only. @throws std::invalid_argument for one that was placed
template <int Dim> void check_not_placed(const ContactSetup<Dim>& setup, const ContactState<Dim>& state);

/// @throws std::invalid_argument for a tool inside the workpiece at the start of a run
template <int Dim>
void check_not_inside(const ContactSetup<Dim>& setup, const MeshLocator<Dim>& locator,
                      const ContactState<Dim>& state, const Eigen::VectorXd& u);

/// A coordinate under force zero of a tool that touches nothing is idle: it keeps its rate, or its place.
/// @param first step of the run: idle is then only a tool that a motion brings on
/// @returns names of the idle ones, for reports. @throws std::invalid_argument for another coordinate under force of a
/// tool that touches nothing, unless the force itself holds it (a spring) or the tool of a coordinate that follows it
/// touches
template <int Dim>
std::vector<std::string> check_support(const ContactSetup<Dim>& setup, const ContactState<Dim>& state,
                                       const PrescribedValues& prescribed, bool first);

/// Coordinates under force that move their tool alike share a force in no certain way.
/// @throws std::invalid_argument for such coordinates
template <int Dim>
void check_independent(const ContactSetup<Dim>& setup, const ContactState<Dim>& state,
                       const PrescribedValues& prescribed);

} // namespace burnish
