#pragma once
// What may be behind a step that fails however short it is, for messages.
#include "stepping/contact_setup.hpp"

namespace burnish {

/// A failed step from the state at t.
template <int Dim> struct FailedStep {
  const ContactState<Dim>* state;
  const PrescribedValues* prescribed;
  double t, dt, largest_dt; ///< largest_dt: of the run so far
};

/// Halving the step makes a motion smaller, unless the program jumps: says so, or "".
template <int Dim> std::string program_jump(const ContactSetup<Dim>& setup, const FailedStep<Dim>& step);
/// A node that passes the end of an open tool loses its force there at once: says so, or "".
template <int Dim> std::string end_of_tool(const ContactSetup<Dim>& setup, const ContactState<Dim>& state);

} // namespace burnish
