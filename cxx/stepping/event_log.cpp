#include "stepping/event_log.hpp"
#include <algorithm>

namespace burnish {
namespace {

EventKind kind_for(PointChange change) {
  if (change == PointChange::USER) return EventKind::USER;
  return change == PointChange::YIELD ? EventKind::YIELD : EventKind::UNLOADING;
}

// The events from `first` on are new, in any order; those of the same step may be later than some of them.
template <int Dim> void sort_in(std::vector<ContactEvent<Dim>>& events, std::ptrdiff_t first) {
  const auto earlier = [](const auto& a, const auto& b) { return a.t < b.t; };
  const auto added = events.begin() + first;
  std::stable_sort(added, events.end(), earlier);
  std::inplace_merge(events.begin(), added, events.end(), earlier);
}

} // namespace

template <int Dim> void EventLog<Dim>::add(const std::vector<ContactEvent<Dim>>& more) {
  const auto first = static_cast<std::ptrdiff_t>(events.size());
  events.insert(events.end(), more.begin(), more.end());
  sort_in(events, first);
}

template <int Dim> void EventLog<Dim>::add(const std::vector<ElementEvent<Dim>>& more, double t, double dt) {
  const auto first = static_cast<std::ptrdiff_t>(events.size());
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
  sort_in(events, first);
}

template struct EventLog<2>;
template struct EventLog<3>;

} // namespace burnish
