#include "material/j2/law.hpp"
#include "material/j2/backstress_update.hpp"
#include "material/j2/batch/kernel.hpp"
#include "material/j2/elastic_path.hpp"
#include "material/j2/internal.hpp"
#include "material/j2/rate_law.hpp"
#include <algorithm>

namespace burnish {
namespace {

template <int Dim> J2Start<Dim> start_of(const PointStep<Dim>& step) {
  return {step.old.stress, step.old.internal[EP], step.old.strain_increment, step.old.plastic,
          step.old.internal + BACKSTRESS};
}

template <int Dim>
StepKinematics<Dim> kinematics_of(const J2Parameters& material, const PointStep<Dim>& step) {
  return step_kinematics(step.old.F, step.F, step.options.strain_frame, material.rate);
}

template <int Dim> PointScheme scheme_of(const PointStep<Dim>& step, int substeps) {
  return {step.options.update, step.options.path_limit, step.ratio, substeps};
}

// The yield condition sees the stress less the back stress.
template <int Dim>
int needed_substeps(const J2Parameters& material, const PointStep<Dim>& step, const StepKinematics<Dim>& kin,
                    const ElasticTrial<Dim>& elastic) {
  const double plastic_strain_eq = step.old.internal[EP];
  if (!material.kinematic.exists())
    return substeps_needed<Dim>(material, step.options, elastic, plastic_strain_eq, step.old.plastic);
  ElasticTrial<Dim> relative = elastic;
  relative.s_old -= turned_backstress(start_of(step), kin);
  return substeps_needed<Dim>(material, step.options, relative, plastic_strain_eq, step.old.plastic);
}

// Numbers of substeps may only grow in the first iterations; a point that yields later gets one then.
template <int Dim>
int chosen_substeps(const J2Parameters& material, const PointStep<Dim>& step, const StepKinematics<Dim>& kin,
                    const ElasticTrial<Dim>& elastic, PointTrial& trial) {
  if (step.options.update != StressUpdate::SUBSTEPPED) return 0;
  const int needed = needed_substeps(material, step, kin, elastic);
  if (needed == 0) return 0;
  const bool may_grow = step.iteration < FREEZE_ITERATION || trial.substeps == 0;
  if (may_grow) trial.substeps = std::max(trial.substeps, needed);
  return trial.substeps;
}

} // namespace

std::vector<InternalVariable> j2_internal_variables(const J2Parameters& material) {
  std::vector<InternalVariable> list = {{"plastic_strain_eq", "ep", "-", TensorKind::SCALAR, 0}};
  if (material.kinematic.exists()) list.push_back({"backstress", "", "stress", TensorKind::SYMMETRIC, 0});
  return list;
}

template <int Dim>
J2Law<Dim>::J2Law(J2Parameters material)
    : MaterialLaw<Dim>("J2", j2_internal_variables(material)), m_material(std::move(material)) {
  require_valid(m_material, "J2Law");
}

template <int Dim>
PointResult J2Law<Dim>::update(const PointStep<Dim>& step, PointTrial& trial, PointUpdate<Dim>& now) const {
  const StepKinematics<Dim> kin = kinematics_of(m_material, step);
  const PointResult result = determinant_result(kin.det_mid);
  if (result.status != UpdateStatus::OK) return result;
  const ElasticTrial<Dim> elastic = elastic_trial<Dim>(m_material.elastic, kin, step.old.stress);
  trial.used = chosen_substeps(m_material, step, kin, elastic, trial);
  const J2End<Dim> end =
      updated_point<Dim>(m_material, scheme_of(step, trial.used), start_of(step), kin, elastic);
  now.stress = end.stress;
  now.internal[EP] = end.plastic_strain_eq;
  if (m_material.kinematic.exists()) Eigen::Map<Stress<Dim>>(now.internal + BACKSTRESS) = end.backstress;
  now.strain_increment = kin.strain;
  now.plastic = end.plastic;
  if (!std::isfinite(end.plastic_strain_eq)) return {UpdateStatus::NO_RETURN, step.old.internal[EP]};
  return result;
}

template <int Dim>
RangeResult J2Law<Dim>::update_range(const RangeStep<Dim>& step, const RangeUpdate<Dim>& now) const {
  if constexpr (Dim == 2) {
    const J2Kernel kernel = j2_kernel();
    if (kernel.update && covered(m_material, step.options)) {
      for (int k = 0; k < step.size;) {
        k = kernel.update(m_material, step, k, now);
        // what is left, and points among which one fails
        for (const int end = std::min(k + kernel.width, step.size); k < end; ++k) {
          const PointResult result = this->update_one(step, k, now);
          if (result.status != UpdateStatus::OK) return {result, k};
        }
      }
      return {};
    }
  }
  return MaterialLaw<Dim>::update_range(step, now);
}

template <int Dim>
PiolaTangent<Dim> J2Law<Dim>::tangent(TangentKind kind, const PointStep<Dim>& step, const PointTrial& trial,
                                      const PointState<Dim>& now) const {
  if (kind != TangentKind::CONSISTENT) {
    const bool plastic = kind == TangentKind::RATE && now.plastic;
    return rate_tangent<Dim>(m_material, now.stress, now.internal[EP], now.F, plastic,
                             now.internal + BACKSTRESS);
  }
  const StepKinematics<Dim> kin =
      step_kinematics(step.old.F, Gradient<Dim>(now.F), step.options.strain_frame, m_material.rate);
  return consistent_tangent<Dim>(m_material, scheme_of(step, trial.used), start_of(step), kin, now.F,
                                 now.stress);
}

template <int Dim> std::map<std::string, double> J2Law<Dim>::moduli() const {
  std::map<std::string, double> all{{"G", m_material.elastic.G}, {"K", m_material.elastic.K}};
  if (m_material.kinematic.exists()) {
    all["C"] = m_material.kinematic.modulus;
    all["gamma"] = m_material.kinematic.recovery;
  }
  return all;
}

template <int Dim> StepIncrements<Dim> J2Law<Dim>::increments(const PointStep<Dim>& step) const {
  return increments_of(kinematics_of(m_material, step));
}

template <int Dim>
double J2Law<Dim>::yield_distance(const Stress<Dim>& stress, const double* internal) const {
  const Stress<Dim> xi = relative_stress<Dim>(m_material, deviator<Dim>(stress), internal);
  return equivalent<Dim>(xi) / m_material.yield_stress(internal[EP]).value - 1;
}

template <int Dim> bool J2Law<Dim>::loads(const PointState<Dim>& at, const Stress<Dim>& strain_rate) const {
  const Stress<Dim> xi = relative_stress<Dim>(m_material, deviator<Dim>(at.stress), at.internal);
  return burnish::loads<Dim>(m_material, xi, at.internal[EP], strain_rate, at.plastic);
}

template <int Dim>
double J2Law<Dim>::yield_fraction(const PointStep<Dim>& step, double last, double noise) const {
  return elastic_yield_fraction<Dim>(m_material, step, last, noise);
}

template <int Dim> PointLoading J2Law<Dim>::loading(const PointStep<Dim>& step) const {
  return elastic_loading<Dim>(m_material, step);
}

template class J2Law<2>;
template class J2Law<3>;

} // namespace burnish
