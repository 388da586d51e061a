#pragma once
// Steps of a run as its diagnosis sees them.
#include "diagnosis/diagnosis.hpp"
#include "run/contact_run.hpp"

namespace burnish {

/// The accepted state, at its time. @param workpiece null: the forms of a script
template <int Dim>
AcceptedStep<Dim> accepted_step(const ContactRun<Dim>& run, const Workpiece<Dim>* workpiece);

/// Why the step under way has failed, in words: what the iteration found, what may be behind it, what the caller refused.
template <int Dim>
std::string reason(const ContactRun<Dim>& run, const Diagnosis<Dim>& diagnosis,
                   const Workpiece<Dim>* workpiece, const std::string& refusal = "");

} // namespace burnish
