#include "workpiece/element_events.hpp"
#include "base/error.hpp"
#include "workpiece/point_fields.hpp"
#include "workpiece/point_place.hpp"
#include <algorithm>

namespace burnish {
namespace {

// Instant of the change of sign between the mean rates of two steps, which belong to their middles.
double sign_change(double rate_old, double dt_old, double rate, double dt) {
  if (!(rate_old > 0)) return 0;
  const double after_middle = 0.5 * (dt_old + dt) * rate_old / (rate_old - rate);
  return std::clamp((after_middle - 0.5 * dt_old) / dt, 0., 1.);
}

// Finds the events of one point after another.
template <int Dim> class Finder {
public:
  Finder(const Workpiece<Dim>& body, double overshoot, double noise)
      : m_body(body), m_last(1 + overshoot), m_noise(noise) {}

  void add_events_of(int point) {
    const PointStep<Dim> step = m_body.point_step(point);
    if (!step.old.plastic) {
      add(point, PointChange::YIELD, m_body.law().yield_fraction(step, m_last, m_noise));
      return;
    }
    const PointLoading loading = m_body.law().loading(step);
    if (loading.now >= 0) return;
    const double again = m_body.law().yield_fraction(step, m_last, m_noise);
    if (m_noise > 0 && loading.elastic_distance >= -m_noise && again == NEVER) return;
    if (m_body.state().plastic[point] && again == NEVER) return;
    const double dt_old = m_body.state_old().dt, dt = m_body.state().dt;
    const double before = dt_old > 0 ? loading.old / dt_old : 0;
    const double f = sign_change(before, dt_old, loading.now / dt, dt);
    add(point, PointChange::UNLOADING, f);
    add(point, PointChange::YIELD, std::max(f, again));
  }

  std::vector<ElementEvent<Dim>> take() {
    std::stable_sort(m_events.begin(), m_events.end(),
                     [](const auto& a, const auto& b) { return a.fraction < b.fraction; });
    return std::move(m_events);
  }

private:
  void add(int point, PointChange change, double fraction) {
    if (fraction == NEVER) return;
    const double f = std::min(fraction, 1.);
    const Discretization<Dim>& mesh = m_body.discretization();
    m_events.push_back({f,
                        change,
                        point,
                        (1 - f) * point_place(mesh, point, m_body.state_old()) +
                            f * point_place(mesh, point, m_body.state()),
                        {}});
  }

  const Workpiece<Dim>& m_body;
  double m_last;  // largest fraction that counts
  double m_noise; // of sigma_y
  std::vector<ElementEvent<Dim>> m_events;
};

} // namespace

template <int Dim>
std::vector<ElementEvent<Dim>> element_events(const Workpiece<Dim>& workpiece, double overshoot,
                                              double noise) {
  require(overshoot >= 0, "element_events", "overshoot", overshoot, ">= 0");
  require(noise >= 0, "element_events", "noise", noise, ">= 0");
  Finder<Dim> finder(workpiece, overshoot, noise);
  for (int p = 0; p < workpiece.discretization().num_points(); ++p) finder.add_events_of(p);
  return finder.take();
}

template <int Dim>
std::vector<ElementEvent<Dim>> earliest(const std::vector<ElementEvent<Dim>>& events, double tolerance) {
  require(tolerance >= 0, "earliest", "tolerance", tolerance, ">= 0");
  std::vector<ElementEvent<Dim>> first;
  for (const auto& event : events)
    if (event.fraction <= events.front().fraction + tolerance) first.push_back(event);
  return first;
}

template <int Dim> double first_fraction(const std::vector<ElementEvent<Dim>>& events) {
  return events.empty() ? 2 : events.front().fraction;
}

template <int Dim>
void accept_events(const std::vector<ElementEvent<Dim>>& events, Workpiece<Dim>& workpiece) {
  for (const auto& event : events)
    if (event.change != PointChange::USER)
      workpiece.set_plastic(event.point, event.change == PointChange::YIELD);
}

template <int Dim> void keep_plastic(double noise, Workpiece<Dim>& workpiece) {
  require(noise >= 0, "keep_plastic", "noise", noise, ">= 0");
  for (int p = 0; p < workpiece.discretization().num_points(); ++p)
    if (workpiece.state_old().plastic[p] && !workpiece.state().plastic[p] &&
        yield_distance(workpiece, p) >= -noise)
      workpiece.set_plastic(p, true);
}

template std::vector<ElementEvent<2>> element_events<2>(const Workpiece<2>&, double, double);
template std::vector<ElementEvent<3>> element_events<3>(const Workpiece<3>&, double, double);
template std::vector<ElementEvent<2>> earliest<2>(const std::vector<ElementEvent<2>>&, double);
template std::vector<ElementEvent<3>> earliest<3>(const std::vector<ElementEvent<3>>&, double);
template double first_fraction<2>(const std::vector<ElementEvent<2>>&);
template double first_fraction<3>(const std::vector<ElementEvent<3>>&);
template void accept_events<2>(const std::vector<ElementEvent<2>>&, Workpiece<2>&);
template void accept_events<3>(const std::vector<ElementEvent<3>>&, Workpiece<3>&);
template void keep_plastic<2>(double, Workpiece<2>&);
template void keep_plastic<3>(double, Workpiece<3>&);

} // namespace burnish
