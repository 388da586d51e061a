#include "material/point_update.hpp"
#include "material/rate_law.hpp"

namespace burnish {
namespace {

template <int Dim> PathHistory<Dim> history_of(const PointScheme& scheme, const PointOld<Dim>& old) {
  return {old.strain_increment, scheme.ratio, scheme.path_limit};
}

// SINGLE is one substep, in which the bend of the path has no share.
int substeps_of(const PointScheme& scheme) {
  return scheme.update == StressUpdate::SINGLE ? 1 : scheme.substeps;
}

} // namespace

template <int Dim>
PointNew<Dim> updated_point(const J2Parameters& material, const PointScheme& scheme, const PointOld<Dim>& old,
                            const StepKinematics<Dim>& kin, const ElasticTrial<Dim>& trial) {
  PointNew<Dim> result{trial.s_old, old.plastic_strain_eq, false};
  Stress<Dim>& s = result.stress;
  const int substeps = substeps_of(scheme);
  if (scheme.update == StressUpdate::FORWARD_EULER) {
    result.plastic =
        forward_euler<Dim>(material, kin, trial.De, s, result.plastic_strain_eq, old.plastic) > 0;
  } else if (substeps == 0) {
    s += trial.De;
  } else {
    const StrainPath<Dim> path = strain_path<Dim>(material, kin, trial.De, history_of(scheme, old), nullptr);
    result.plastic = substepped_return<Dim>(material, path, substeps, s, result.plastic_strain_eq) > 0;
  }
  s.template head<3>().array() += trial.mean;
  return result;
}

template <int Dim>
StressByIncrement<Dim> consistent_moduli(const J2Parameters& material, const PointScheme& scheme,
                                         const PointOld<Dim>& old, const StepKinematics<Dim>& kin,
                                         const ElasticTrial<Dim>& trial) {
  ReturnDerivative<Dim> derivative;
  derivative.s.template rightCols<1>() = spin_rate(trial.s_old);
  Stress<Dim> s = trial.s_old;
  double plastic_strain_eq = old.plastic_strain_eq;
  const int substeps = substeps_of(scheme);
  if (scheme.update == StressUpdate::FORWARD_EULER) {
    derivative.s =
        forward_euler_by_increment<Dim>(material, kin, s, derivative.s, plastic_strain_eq, old.plastic);
  } else if (substeps == 0) {
    derivative.s += deviatoric_moduli<Dim>(material);
  } else {
    PathDerivative<Dim> path_derivative;
    const StrainPath<Dim> path =
        strain_path<Dim>(material, kin, trial.De, history_of(scheme, old), &path_derivative);
    substepped_return<Dim>(material, path, path_derivative, substeps, s, plastic_strain_eq, derivative);
  }
  derivative.s.template topLeftCorner<3, 3>().array() += material.K;
  return derivative.s;
}

template <int Dim>
PiolaTangent<Dim> consistent_tangent(const J2Parameters& material, const PointScheme& scheme,
                                     const PointOld<Dim>& old, const StepKinematics<Dim>& kin,
                                     const Gradient<Dim>& F, const Stress<Dim>& stress) {
  const ElasticTrial<Dim> trial = elastic_trial<Dim>(material, kin, old.stress);
  const StressByIncrement<Dim> moduli = consistent_moduli<Dim>(material, scheme, old, kin, trial);
  return piola_tangent(moduli * finite_increment_by_F(kin), stress, inverse(F));
}

template <int Dim>
PiolaTangent<Dim> rate_tangent(const J2Parameters& material, const Stress<Dim>& stress,
                               const Gradient<Dim>& F, bool plastic) {
  const Gradient<Dim> F_inverse = inverse(F);
  return piola_tangent(rate_moduli<Dim>(material, stress, plastic) * rate_by_F(F_inverse), stress, F_inverse);
}

template PointNew<2> updated_point<2>(const J2Parameters&, const PointScheme&, const PointOld<2>&,
                                      const StepKinematics<2>&, const ElasticTrial<2>&);
template StressByIncrement<2> consistent_moduli<2>(const J2Parameters&, const PointScheme&,
                                                   const PointOld<2>&, const StepKinematics<2>&,
                                                   const ElasticTrial<2>&);
template PiolaTangent<2> consistent_tangent<2>(const J2Parameters&, const PointScheme&, const PointOld<2>&,
                                               const StepKinematics<2>&, const Gradient<2>&,
                                               const Stress<2>&);
template PiolaTangent<2> rate_tangent<2>(const J2Parameters&, const Stress<2>&, const Gradient<2>&, bool);

} // namespace burnish
