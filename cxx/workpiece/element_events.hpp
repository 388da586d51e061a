#pragma once
// Events of quadrature points inside a step: first yield and elastic unloading, located in the fraction of
// the step (METHOD.md 4.2, ALGORITHMS.md 10). Knows no tool.
#include "workpiece/workpiece.hpp"
#include <string>

namespace burnish {

/// USER: by a user-defined formula, see point_events.hpp.
enum class PointChange : char { YIELD, UNLOADING, USER };

template <int Dim> struct ElementEvent {
  double fraction = 0; ///< of the step from state_old to state, 0..1
  PointChange change = PointChange::YIELD;
  int point = -1;                      ///< quadrature point
  Vector<Dim> x = Vector<Dim>::Zero(); ///< its place at that instant [length]
  std::string name = {};               ///< USER: that of the event
};

/// All events of the step that the last update made, by fraction. The displacement is linear in the fraction;
/// the law says where its surface is. YIELD: a point that did not flow in the last step leaves the yield
/// surface; the fraction is MaterialLaw::yield_fraction: a step cut there ends on the surface. A point on the
/// surface (or outside, which only forward Euler gives) yields at once if it loads. UNLOADING: a point that
/// flowed in the last step has a loading power s:dd < 0 now; the loading rates s:dd/dt are means of their
/// steps, so they belong to the middles, and the fraction is that of the change of sign between them, 0 if it
/// is in the last step. A point that yields again in the same step has both events. A point that
/// state().plastic contradicts (the return on a curved path flowed all the same) has no event.
/// @param overshoot points that would yield before 1 + overshoot count, with the fraction 1 (>= 0)
/// @param noise >= 0 [fraction of sigma_y]: a point this near to the surface has no event unless the step takes
///        q further than this from it: for steps so short that the residual's tolerance shakes the points
/// @throws std::invalid_argument if overshoot < 0 or noise < 0
template <int Dim>
std::vector<ElementEvent<Dim>> element_events(const Workpiece<Dim>& workpiece, double overshoot,
                                              double noise = 0);

/// Those within the tolerance of the earliest one (article: event tolerance, in fractions of the step).
/// @param events by fraction, as element_events returns them; @throws std::invalid_argument if tolerance < 0
template <int Dim>
std::vector<ElementEvent<Dim>> earliest(const std::vector<ElementEvent<Dim>>& events, double tolerance);

/// Fraction of the first one, 2 if there is none. @param events by fraction
template <int Dim> double first_fraction(const std::vector<ElementEvent<Dim>>& events);

/// Transition of the accepted state at element events: points that yielded start the next step on the surface, points
/// that unloaded inside it. Right after accept (a step cut at these events) or revert (events at its start).
template <int Dim>
void accept_events(const std::vector<ElementEvent<Dim>>& events, Workpiece<Dim>& workpiece);

/// The other side of `noise`, a transition of the state that is about to be accepted: points that flowed in
/// the last step and rest now within the noise of the surface count as flowing still. Right before accept.
/// @throws std::invalid_argument if noise < 0
template <int Dim> void keep_plastic(double noise, Workpiece<Dim>& workpiece);

} // namespace burnish
