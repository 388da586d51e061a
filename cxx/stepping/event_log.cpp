#include "stepping/event_log.hpp"
#include <algorithm>

namespace burnish {
namespace {

EventKind kind_for(PointChange change) {
  if (change == PointChange::USER) return EventKind::USER;
  return change == PointChange::YIELD ? EventKind::YIELD : EventKind::UNLOADING;
}

} // namespace

template <int Dim> void EventLog<Dim>::add(const std::vector<ContactEvent<Dim>>& more) {
  events.insert(events.end(), more.begin(), more.end());
}

template <int Dim> void EventLog<Dim>::add(const std::vector<ElementEvent<Dim>>& more, double t, double dt) {
  auto first = static_cast<std::ptrdiff_t>(events.size()); // of this step's element events
  while (first > 0 && events[first - 1].candidate < 0 && events[first - 1].t >= t) --first;
  for (const auto& found : more) {
    ContactEvent<Dim> event;
    event.t = t + found.fraction * dt;
    event.fraction = found.fraction;
    event.kind = kind_for(found.change);
    event.node = found.point;
    event.x = found.x;
    event.name = found.name;
    events.push_back(event);
  }
  std::stable_sort(events.begin() + first, events.end(),
                   [](const auto& a, const auto& b) { return a.t < b.t; });
}

template struct EventLog<2>;
template struct EventLog<3>;

} // namespace burnish
