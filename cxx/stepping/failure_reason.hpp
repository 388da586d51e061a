#pragma once
// What may be behind a step that fails however short it is, for messages.
#include "stepping/contact_setup.hpp"

namespace burnish {

/// A failed step from the state at t.
template <int Dim> struct FailedStep {
  const ContactState<Dim>* state;
  const PrescribedValues* prescribed;
  const PrescribedValues* before; ///< at the end of the last step; empty: there was none
  double t, dt, largest_dt;       ///< largest_dt: of the run so far
};

/// Halving the step makes a change of motion or force smaller, unless the program jumps: says so, or "".
template <int Dim> std::string program_jump(const ContactSetup<Dim>& setup, const FailedStep<Dim>& step);
/// A node that passes the end of an open tool loses its force there at once: says so, or "".
template <int Dim> std::string end_of_tool(const ContactSetup<Dim>& setup, const ContactState<Dim>& state);
/// A body to which supports leave a rigid motion, held by four nodes in contact or fewer: says so, or "".
template <int Dim> std::string hangs_on_few(const ContactSetup<Dim>& setup, const ContactState<Dim>& state);

/// A body that supports leave a rigid motion which the nodes in contact do not take either, the tools at rest; or "".
template <int Dim>
std::string unheld_workpiece(const ContactSetup<Dim>& setup, const ContactState<Dim>& state,
                             const Eigen::VectorXd& u);
/// A force that draws its tool away from all nodes that it touches: says so, or "".
template <int Dim>
std::string pulling_force(const ContactSetup<Dim>& setup, const ContactState<Dim>& state,
                          const PrescribedValues& prescribed);
/// The last equilibrium in words: its time, and force and place of every coordinate under a force other than zero; if there
/// is none, of those under motion. @param force on the tools, one per coordinate
template <int Dim>
std::string last_equilibrium(const ContactSetup<Dim>& setup, const PrescribedValues& prescribed,
                             const Eigen::VectorXd& q, const Eigen::VectorXd& force, double t);

} // namespace burnish
