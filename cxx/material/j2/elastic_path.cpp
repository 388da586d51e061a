#include "material/j2/elastic_path.hpp"
#include "material/j2/internal.hpp"
#include "material/j2/rate_law.hpp"
#include <algorithm>

namespace burnish {
namespace {

/// Loading and unloading are distinguished from s:dd = +-NEUTRAL |s||dd| on: for rounding only.
constexpr double NEUTRAL = 1e-12;
/// A root of the straight path this far beyond `last`, relatively, is not looked at: the true path is close to it.
constexpr double STRAIGHT_ERROR = 0.01;
/// Of the secant iteration: passes, |q/sigma_y - 1| at its end, and the least slope relative to the straight path's.
constexpr int MAX_SECANTS = 20;
constexpr double ON_SURFACE = 1e-15, LEAST_SLOPE = 0.1;

/// One point's elastic path through the step: the step of the fraction f of the displacement. The stress of its trials is
/// relative to the back stress.
template <int Dim> class ElasticPath {
public:
  ElasticPath(const J2Parameters& material, const PointStep<Dim>& step)
      : m_material(material), m_step(step), m_dF(step.F - step.old.F),
        m_yield(material.yield_stress(step.old.internal[EP]).value),
        m_relative(relative_stress<Dim>(material, step.old.stress, step.old.internal)) {}

  double yield() const { return m_yield; } ///< sigma_y(ep) at the start
  StepKinematics<Dim> kinematics(double f) const {
    const Gradient<Dim> F = m_step.old.F + f * m_dF;
    return step_kinematics(m_step.old.F, F, m_step.options.strain_frame, m_material.rate);
  }
  ElasticTrial<Dim> trial(const StepKinematics<Dim>& kin) const {
    return elastic_trial<Dim>(m_material.elastic, kin, m_relative);
  }
  double excess(const ElasticTrial<Dim>& trial) const { // q/sigma_y - 1
    return equivalent<Dim>(trial.s_old + trial.elastic_increment) / m_yield - 1;
  }
  double excess(double f) const { return excess(trial(kinematics(f))); }

private:
  const J2Parameters& m_material;
  const PointStep<Dim>& m_step;
  Gradient<Dim> m_dF;
  double m_yield;
  Stress<Dim> m_relative; // stress less X at the start
};

/// Root of excess(f) near f, with the slope that the straight path has there; secants after the first step.
template <int Dim> double refined(const ElasticPath<Dim>& path, double f, double slope) {
  double value = path.excess(f);
  for (int it = 0; it < MAX_SECANTS && std::abs(value) > ON_SURFACE; ++it) {
    const double next = std::max(0., f - value / slope), next_value = path.excess(next);
    if (next == f) break;
    const double secant = (next_value - value) / (next - f);
    if (secant > LEAST_SLOPE * slope) slope = secant;
    f = next;
    value = next_value;
  }
  return f;
}

} // namespace

// Straight path first: q^2(f) - sigma_y^2 = a f^2 + 2 b f + c.
template <int Dim>
double elastic_yield_fraction(const J2Parameters& material, const PointStep<Dim>& step, double last,
                              double noise) {
  const ElasticPath<Dim> path(material, step);
  const StepKinematics<Dim> kin = path.kinematics(1);
  if (!(kin.det_mid > 0)) return NEVER;
  const ElasticTrial<Dim> trial = path.trial(kin);
  const double yield = path.yield(), a = squared_equivalent<Dim>(trial.elastic_increment);
  const double b = 1.5 * contract<Dim>(trial.s_old, trial.elastic_increment);
  const double q2 = squared_equivalent<Dim>(trial.s_old), c = q2 - yield * yield;
  if (a == 0) return NEVER;
  const bool near = noise > 0 && q2 >= std::pow((1 - noise) * yield, 2);
  if (near && a + 2 * b + q2 <= std::pow((1 + noise) * yield, 2)) return NEVER;
  const bool outside = near || q2 >= std::pow(YIELD_FRACTION * yield, 2);
  if (outside && b >= 0) return b > NEUTRAL * std::sqrt(a * q2) ? 0 : NEVER;
  const double discriminant = b * b - a * c;
  if (discriminant <= 0)
    return -b / a <= last ? -b / a : NEVER; // outside all along: from where it loads again
  const double root = std::sqrt(discriminant), f = (root - b) / a;
  if (f > (1 + STRAIGHT_ERROR) * last) return NEVER;
  const double found = refined(path, f, root / (yield * yield)); // dq/df = (a f + b)/q
  return found <= last ? found : NEVER;
}

template <int Dim> PointLoading elastic_loading(const J2Parameters& material, const PointStep<Dim>& step) {
  const ElasticPath<Dim> path(material, step);
  const StepKinematics<Dim> kin = path.kinematics(1);
  PointLoading loading;
  if (!(kin.det_mid > 0)) return loading;
  const ElasticTrial<Dim> trial = path.trial(kin);
  const double now = contract<Dim>(trial.s_old, kin.strain);
  const bool neutral = std::abs(now) <= NEUTRAL * trial.s_old.norm() * kin.strain.norm();
  const Stress<Dim> xi_old =
      relative_stress<Dim>(material, deviator<Dim>(step.old.stress), step.old.internal);
  loading.old = contract<Dim>(xi_old, step.old.strain_increment);
  loading.now = neutral ? 0 : now;
  loading.elastic_distance = path.excess(trial);
  return loading;
}

template double elastic_yield_fraction<2>(const J2Parameters&, const PointStep<2>&, double, double);
template double elastic_yield_fraction<3>(const J2Parameters&, const PointStep<3>&, double, double);
template PointLoading elastic_loading<2>(const J2Parameters&, const PointStep<2>&);
template PointLoading elastic_loading<3>(const J2Parameters&, const PointStep<3>&);

} // namespace burnish
