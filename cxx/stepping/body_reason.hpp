#pragma once
// What in the workpiece may be behind a step that fails however short it is, for messages.
#include "workpiece/workpiece.hpp"

namespace burnish {

/// A body so close to incompressible that small errors of its volume are large stresses: says so, and what to do; or "".
/// @param workpiece null, and laws without moduli: ""
template <int Dim> std::string nearly_incompressible(const Workpiece<Dim>* workpiece);

} // namespace burnish
