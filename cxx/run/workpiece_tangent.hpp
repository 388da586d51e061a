#pragma once
// The tangent of a workpiece for the contact: its factor, or the iteration by it.
#include "run/contact_run.hpp"
#include "workpiece/workpiece.hpp"

namespace burnish {

/// Assembles the consistent tangent and factorizes it; where it is not positive definite, elastic moduli are mixed in
/// (Corrector::elastic_blend) and it is tried again. The tangent itself is not kept.
/// @returns false if it stays indefinite: the step fails
/// @throws std::invalid_argument if workpiece and contact have different spaces, or disagree on axisymmetry
template <int Dim>
bool factorize_tangent(ContactRun<Dim>& contact, const Workpiece<Dim>& workpiece, const Eigen::VectorXd& u);

/// The same; or, in a step of IMPLICIT whose contact is large (CondensedStep::pays), the next iteration itself by the condensed
/// system: u and the state move. @param workpiece updated at u
/// @returns, throws as factorize_tangent
template <int Dim>
bool take_tangent(ContactRun<Dim>& contact, const Workpiece<Dim>& workpiece, Eigen::VectorXd& u);

} // namespace burnish
