#pragma once
// The factor of a workpiece's own tangent for the contact.
#include "run/contact_run.hpp"
#include "workpiece/workpiece.hpp"

namespace burnish {

/// Assembles the consistent tangent and factorizes it; where it is not positive definite, elastic moduli are mixed in
/// (Corrector::elastic_blend) and it is tried again. The tangent itself is not kept.
/// @returns false if it stays indefinite: the step fails
/// @throws std::invalid_argument if workpiece and contact have different spaces, or disagree on axisymmetry
template <int Dim>
bool factorize_tangent(ContactRun<Dim>& contact, const Workpiece<Dim>& workpiece, const Eigen::VectorXd& u);

} // namespace burnish
