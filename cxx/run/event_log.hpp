#pragma once
// All events of a run, in the order of time.
#include "contact/events.hpp"
#include "workpiece/element_events.hpp"

namespace burnish {

template <int Dim> struct EventLog {
  std::vector<ContactEvent<Dim>> events;

  void add(const std::vector<ContactEvent<Dim>>& more);
  /// Events of quadrature points in the step from t of length dt: candidate and tool -1, node = quadrature point. They
  /// are sorted among those of the same step.
  void add(const std::vector<ElementEvent<Dim>>& more, double t, double dt);
};

} // namespace burnish
