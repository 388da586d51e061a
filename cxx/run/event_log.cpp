#include "run/event_log.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

EventKind kind_for(PointChange change) {
  if (change == PointChange::USER) return EventKind::USER;
  return change == PointChange::YIELD ? EventKind::YIELD : EventKind::UNLOADING;
}

// Instants this close are one: what is symmetric happens at once, in the order in which it was found.
bool at_once(double earlier, double later) { return later - earlier <= 1e-7 * std::abs(later); }

// The events from `first` on are new, in any order; those of the same step may be later than some of them.
template <int Dim> void sort_in(std::vector<ContactEvent<Dim>>& events, std::size_t first) {
  if (first == events.size()) return;
  double least = events[first].t;
  for (std::size_t k = first; k < events.size(); ++k) least = std::min(least, events[k].t);
  while (first > 0 && (events[first - 1].t > least || at_once(events[first - 1].t, least))) --first;
  std::vector<std::size_t> order(events.size() - first);
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = first + k;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return events[a].t < events[b].t; });
  for (std::size_t begin = 0, end; begin < order.size(); begin = end) {
    end = begin + 1;
    while (end < order.size() && at_once(events[order[end - 1]].t, events[order[end]].t)) ++end;
    std::sort(order.begin() + begin, order.begin() + end);
  }
  const std::vector<ContactEvent<Dim>> tail(events.begin() + first, events.end());
  for (std::size_t k = 0; k < order.size(); ++k) events[first + k] = tail[order[k] - first];
}

} // namespace

template <int Dim> void EventLog<Dim>::add(const std::vector<ContactEvent<Dim>>& more) {
  const std::size_t first = events.size();
  events.insert(events.end(), more.begin(), more.end());
  sort_in(events, first);
}

template <int Dim> void EventLog<Dim>::add(const std::vector<ElementEvent<Dim>>& more, double t, double dt) {
  const std::size_t first = events.size();
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
