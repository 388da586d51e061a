#pragma once
// How wide the contact is and how fast it moves, for the step control.
#include "run/contact_run.hpp"

namespace burnish {

/// Largest contact width of a tool in the accepted state, and speed of the contact along the body in the last step; 0: unknown
/// [length, length/time].
template <int Dim> double contact_width(const ContactRun<Dim>& run);
template <int Dim> double contact_speed(const ContactRun<Dim>& run);
/// Coordinates left out so far, in the step under way too, since nothing resists them.
template <int Dim> std::vector<std::string> left_out(const ContactRun<Dim>& run);

} // namespace burnish
