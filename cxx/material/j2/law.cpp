#include "material/j2/law.hpp"
#include "material/j2/elastic_path.hpp"
#include "material/j2/rate_law.hpp"
#include <algorithm>

namespace burnish {
namespace {

constexpr int EP = 0; // place of plastic_strain_eq among the internal variables

template <int Dim> J2Start<Dim> start_of(const PointStep<Dim>& step) {
  return {step.old.internal[EP], step.old.strain_increment, step.old.plastic};
}

template <int Dim> PointScheme scheme_of(const PointStep<Dim>& step, int substeps) {
  return {step.options.update, step.options.path_limit, step.ratio, substeps};
}

// Numbers of substeps may only grow in the first iterations; a point that yields later gets one then.
template <int Dim>
int chosen_substeps(const J2Parameters& material, const PointStep<Dim>& step,
                    const ElasticTrial<Dim>& elastic, PointTrial& trial) {
  if (step.options.update != StressUpdate::SUBSTEPPED) return 0;
  const int needed =
      substeps_needed<Dim>(material, step.options, elastic, step.old.internal[EP], step.old.plastic);
  if (needed == 0) return 0;
  const bool may_grow = step.iteration < step.options.freeze_iteration || trial.substeps == 0;
  if (may_grow) trial.substeps = std::max(trial.substeps, needed);
  return trial.substeps;
}

} // namespace

template <int Dim>
J2Law<Dim>::J2Law(J2Parameters material)
    : MaterialLaw<Dim>("J2", {{"plastic_strain_eq", "ep", "-", TensorKind::SCALAR, 0}}),
      m_material(std::move(material)) {
  require_valid(m_material, "J2Law");
}

template <int Dim>
PointResult J2Law<Dim>::update(const PointStep<Dim>& step, PointTrial& trial, PointUpdate<Dim>& now) const {
  const StepKinematics<Dim> kin = step_kinematics(step.old.F, step.F, step.options.strain_frame);
  const PointResult result = determinant_result(kin.det_mid);
  if (result.status != UpdateStatus::OK) return result;
  const ElasticTrial<Dim> elastic = elastic_trial<Dim>(m_material.elastic, kin, step.old.stress);
  trial.used = chosen_substeps(m_material, step, elastic, trial);
  const J2End<Dim> end =
      updated_point<Dim>(m_material, scheme_of(step, trial.used), start_of(step), kin, elastic);
  now.stress = end.stress;
  now.internal[EP] = end.plastic_strain_eq;
  now.strain_increment = kin.strain;
  now.plastic = end.plastic;
  return result;
}

template <int Dim>
PiolaTangent<Dim> J2Law<Dim>::tangent(TangentKind kind, const PointStep<Dim>& step, const PointTrial& trial,
                                      const PointState<Dim>& now) const {
  if (kind != TangentKind::CONSISTENT) {
    const bool plastic = kind == TangentKind::RATE && now.plastic;
    return rate_tangent<Dim>(m_material, now.stress, now.internal[EP], now.F, plastic);
  }
  const StepKinematics<Dim> kin = step_kinematics(step.old.F, now.F, step.options.strain_frame);
  return consistent_tangent<Dim>(m_material, scheme_of(step, trial.used), start_of(step), step.old.stress,
                                 kin, now.F, now.stress);
}

template <int Dim> StepIncrements<Dim> J2Law<Dim>::increments(const PointStep<Dim>& step) const {
  return increments_of(step_kinematics(step.old.F, step.F, step.options.strain_frame));
}

template <int Dim>
double J2Law<Dim>::yield_distance(const Stress<Dim>& stress, const double* internal) const {
  return equivalent<Dim>(deviator<Dim>(stress)) / m_material.yield_stress(internal[EP]).value - 1;
}

template <int Dim> bool J2Law<Dim>::loads(const PointState<Dim>& at, const Stress<Dim>& strain_rate) const {
  return burnish::loads<Dim>(m_material, deviator<Dim>(at.stress), at.internal[EP], strain_rate, at.plastic);
}

template <int Dim>
double J2Law<Dim>::yield_fraction(const PointStep<Dim>& step, double last, double noise) const {
  return elastic_yield_fraction<Dim>(m_material, step, step.old.internal[EP], last, noise);
}

template <int Dim> PointLoading J2Law<Dim>::loading(const PointStep<Dim>& step) const {
  return elastic_loading<Dim>(m_material, step, step.old.internal[EP]);
}

template class J2Law<2>;

} // namespace burnish
