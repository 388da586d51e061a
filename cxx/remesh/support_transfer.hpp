#pragma once
// Supports that have moved, on a new mesh of the body (ALGORITHMS.md 19.3).
#include "run/contact_run.hpp"

namespace burnish {

/// What was prescribed for the supports of the old mesh, at those of the new one: the value of the nearest one of the same component;
/// empty where nothing was prescribed, or zero. @returns num_dofs of the new mesh [length]
/// @throws std::invalid_argument for a support that turns or is stretched, whose values change along it; for a component that is given on
///         the new mesh where it was not on the old one
template <int Dim> Eigen::VectorXd supports_on(const ContactRun<Dim>& old, const ContactSetup<Dim>& fresh);

} // namespace burnish
