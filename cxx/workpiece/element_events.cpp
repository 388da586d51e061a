#include "workpiece/element_events.hpp"
#include "base/error.hpp"
#include "material/rate_law.hpp"
#include "workpiece/point_place.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace burnish {
namespace {

constexpr double NEVER = std::numeric_limits<double>::infinity();
/// Loading and unloading are told apart from s:dd = +-NEUTRAL |s||dd| on: for rounding only.
constexpr double NEUTRAL = 1e-12;

// One point's elastic path through the step: the step of the fraction f of the displacement.
template <int Dim> struct ElasticPath {
  const J2Parameters& material;
  StrainFrame frame;
  Gradient<Dim> F_old, dF;
  Stress<Dim> stress_old;
  double yield; // sigma_y(ep) at the start

  ElasticTrial<Dim> at(double f) const {
    const StepKinematics<Dim> kin = step_kinematics(F_old, F_old + f * dF, frame);
    return elastic_trial<Dim>(material, kin, stress_old);
  }
  double excess(double f) const { // q/sigma_y - 1
    const ElasticTrial<Dim> trial = at(f);
    return equivalent<Dim>(trial.s_old + trial.De) / yield - 1;
  }
};

template <int Dim> Gradient<Dim> gradient_at(const std::vector<double>& F, int point) {
  return Eigen::Map<const Gradient<Dim>>(F.data() + static_cast<std::size_t>(num_gradient<Dim>) * point);
}
template <int Dim> Stress<Dim> stress_at(const std::vector<double>& all, int point) {
  return Eigen::Map<const Stress<Dim>>(all.data() + static_cast<std::size_t>(num_stress<Dim>) * point);
}

// Root of excess(f) near f, with the slope that the straight path has there; secants after the first step.
template <int Dim> double refined(const ElasticPath<Dim>& path, double f, double slope) {
  double value = path.excess(f);
  for (int it = 0; it < 20 && std::abs(value) > 1e-15; ++it) {
    const double next = std::max(0., f - value / slope), next_value = path.excess(next);
    if (next == f) break;
    const double secant = (next_value - value) / (next - f);
    if (secant > 0.1 * slope) slope = secant;
    f = next;
    value = next_value;
  }
  return f;
}

// Fraction at which the trial stress leaves the surface through its outer side, NEVER if not before `last`.
// Straight path first: q^2(f) - sigma_y^2 = a f^2 + 2 b f + c.
template <int Dim>
double yield_fraction(const ElasticPath<Dim>& path, const ElasticTrial<Dim>& trial, double last,
                      double noise) {
  const double a = squared_equivalent<Dim>(trial.De), b = 1.5 * contract<Dim>(trial.s_old, trial.De);
  const double q2 = squared_equivalent<Dim>(trial.s_old), c = q2 - path.yield * path.yield;
  if (a == 0) return NEVER;
  const bool near = noise > 0 && q2 >= std::pow((1 - noise) * path.yield, 2);
  if (near && a + 2 * b + q2 <= std::pow((1 + noise) * path.yield, 2)) return NEVER;
  const bool outside = near || q2 >= std::pow(YIELD_FRACTION * path.yield, 2);
  if (outside && b >= 0) return b > NEUTRAL * std::sqrt(a * q2) ? 0 : NEVER;
  const double discriminant = b * b - a * c;
  if (discriminant <= 0)
    return -b / a <= last ? -b / a : NEVER; // outside all along: from where it loads again
  const double root = std::sqrt(discriminant), f = (root - b) / a;
  if (f > 1.01 * last) return NEVER; // the true path is close to the straight one
  const double found = refined(path, f, root / (path.yield * path.yield)); // dq/df = (a f + b)/q
  return found <= last ? found : NEVER;
}

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
    const WorkpieceState<Dim>&old = m_body.state_old(), &now = m_body.state();
    const ElasticPath<Dim> path = path_of(point);
    const StepKinematics<Dim> kin = step_kinematics(path.F_old, path.F_old + path.dF, path.frame);
    if (!(kin.det_mid > 0)) return; // the update of the step has failed
    const ElasticTrial<Dim> trial = elastic_trial<Dim>(m_body.material(), kin, path.stress_old);
    if (!old.plastic[point]) {
      add(point, PointChange::YIELD, yield_fraction(path, trial, m_last, m_noise));
      return;
    }
    const double loading = contract<Dim>(trial.s_old, kin.strain);
    if (loading >= -NEUTRAL * trial.s_old.norm() * kin.strain.norm()) return;
    const double again = yield_fraction(path, trial, m_last, m_noise);
    const bool stays = equivalent<Dim>(trial.s_old + trial.De) >= (1 - m_noise) * path.yield;
    if (m_noise > 0 && stays && again == NEVER) return;
    if (now.plastic[point] && again == NEVER) return;
    const double before = old.dt > 0 ? contract<Dim>(deviator<Dim>(path.stress_old),
                                                     stress_at<Dim>(old.strain_increment, point)) /
                                           old.dt
                                     : 0;
    const double f = sign_change(before, old.dt, loading / now.dt, now.dt);
    add(point, PointChange::UNLOADING, f);
    add(point, PointChange::YIELD, std::max(f, again));
  }

  std::vector<ElementEvent<Dim>> take() {
    std::stable_sort(m_events.begin(), m_events.end(),
                     [](const auto& a, const auto& b) { return a.fraction < b.fraction; });
    return std::move(m_events);
  }

private:
  ElasticPath<Dim> path_of(int point) const {
    const WorkpieceState<Dim>&old = m_body.state_old(), &now = m_body.state();
    const Gradient<Dim> F_old = gradient_at<Dim>(old.F, point);
    return {m_body.material(),
            m_body.options().strain_frame,
            F_old,
            gradient_at<Dim>(now.F, point) - F_old,
            stress_at<Dim>(old.stress, point),
            yield_stress_at(m_body.material(), old.plastic_strain_eq[point])};
  }

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

template <int Dim>
void switch_points(const std::vector<ElementEvent<Dim>>& events, Workpiece<Dim>& workpiece) {
  for (const auto& event : events)
    if (event.change != PointChange::SCRIPT)
      workpiece.set_plastic(event.point, event.change == PointChange::YIELD);
}

template <int Dim> void hold_points(double noise, Workpiece<Dim>& workpiece) {
  require(noise >= 0, "hold_points", "noise", noise, ">= 0");
  for (int p = 0; p < workpiece.discretization().num_points(); ++p)
    if (workpiece.state_old().plastic[p] && !workpiece.state().plastic[p] &&
        workpiece.yield_excess(p) >= -noise)
      workpiece.set_plastic(p, true);
}

template std::vector<ElementEvent<2>> element_events<2>(const Workpiece<2>&, double, double);
template std::vector<ElementEvent<2>> earliest<2>(const std::vector<ElementEvent<2>>&, double);
template void hold_points<2>(double, Workpiece<2>&);
template void switch_points<2>(const std::vector<ElementEvent<2>>&, Workpiece<2>&);

} // namespace burnish
