#include "material/j2/point_update.hpp"
#include "material/j2/backstress_update.hpp"
#include "material/j2/rate_law.hpp"

namespace burnish {
template <int Dim>
J2End<Dim> updated_point(const J2Parameters& material, const PointScheme& scheme, const J2Start<Dim>& old,
                         const StepKinematics<Dim>& kin, const ElasticTrial<Dim>& trial) {
  if (material.kinematic.exists()) return updated_with_backstress<Dim>(material, scheme, old, kin, trial);
  J2End<Dim> result{trial.s_old, old.plastic_strain_eq, false};
  Stress<Dim>& s = result.stress;
  double& plastic_strain_eq = result.plastic_strain_eq;
  if (scheme.update == StressUpdate::FORWARD_EULER) {
    result.plastic =
        forward_euler<Dim>(material, kin, trial.elastic_increment, s, plastic_strain_eq, old.plastic) > 0;
  } else if (scheme.update == StressUpdate::SINGLE) {
    s += trial.elastic_increment;
    result.plastic = radial_return<Dim>(material, s, plastic_strain_eq) > 0;
  } else if (scheme.substeps == 0) {
    s += trial.elastic_increment;
  } else {
    const StrainPath<Dim> path =
        strain_path<Dim>(material.elastic, kin, trial.elastic_increment, history_of(scheme, old), nullptr);
    result.plastic = substepped_return<Dim>(material, path, scheme.substeps, s, plastic_strain_eq) > 0;
  }
  s.template head<3>().array() += trial.mean;
  return result;
}

template <int Dim>
StressByIncrement<Dim> consistent_moduli(const J2Parameters& material, const PointScheme& scheme,
                                         const J2Start<Dim>& old, const StepKinematics<Dim>& kin,
                                         const ElasticTrial<Dim>& trial) {
  if (material.kinematic.exists()) return moduli_with_backstress<Dim>(material, scheme, old, kin, trial);
  ReturnDerivative<Dim> derivative;
  derivative.s.template rightCols<PointTraits<Dim>::num_rotations>() = spin_rate(trial.s_old);
  Stress<Dim> s = trial.s_old;
  double plastic_strain_eq = old.plastic_strain_eq;
  if (scheme.update == StressUpdate::FORWARD_EULER) {
    derivative.s =
        forward_euler_by_increment<Dim>(material, kin, s, derivative.s, plastic_strain_eq, old.plastic);
  } else if (scheme.update == StressUpdate::SINGLE) {
    s += trial.elastic_increment;
    derivative.s += deviatoric_moduli<Dim>(material.elastic);
    radial_return<Dim>(material, s, plastic_strain_eq, derivative);
  } else if (scheme.substeps == 0) {
    derivative.s += deviatoric_moduli<Dim>(material.elastic);
  } else {
    PathDerivative<Dim> path_derivative;
    const StrainPath<Dim> path = strain_path<Dim>(material.elastic, kin, trial.elastic_increment,
                                                  history_of(scheme, old), &path_derivative);
    substepped_return<Dim>(material, path, path_derivative, scheme.substeps, s, plastic_strain_eq,
                           derivative);
  }
  derivative.s.template topLeftCorner<3, 3>().array() += material.elastic.K;
  return derivative.s;
}

template <int Dim>
PiolaTangent<Dim> consistent_tangent(const J2Parameters& material, const PointScheme& scheme,
                                     const J2Start<Dim>& old, const StepKinematics<Dim>& kin,
                                     const Gradient<Dim>& F, const Stress<Dim>& stress) {
  const ElasticTrial<Dim> trial = elastic_trial<Dim>(material.elastic, kin, Stress<Dim>(old.stress));
  const StressByIncrement<Dim> moduli = consistent_moduli<Dim>(material, scheme, old, kin, trial);
  const bool small = material.rate == CorotationalRate::SMALL_STRAIN;
  return piola_tangent<Dim>(moduli * finite_increment_by_F(kin), stress, F, small);
}

template <int Dim>
PiolaTangent<Dim> rate_tangent(const J2Parameters& material, const Stress<Dim>& stress,
                               double plastic_strain_eq, const Gradient<Dim>& F, bool plastic,
                               const double* backstress) {
  const bool small = material.rate == CorotationalRate::SMALL_STRAIN;
  const StressByIncrement<Dim> moduli =
      rate_moduli<Dim>(material, stress, plastic_strain_eq, plastic, backstress);
  return piola_tangent<Dim>(moduli * rate_by_F(F, pull_back<Dim>(F, small), material.rate), stress, F, small);
}

template J2End<2> updated_point<2>(const J2Parameters&, const PointScheme&, const J2Start<2>&,
                                   const StepKinematics<2>&, const ElasticTrial<2>&);
template J2End<3> updated_point<3>(const J2Parameters&, const PointScheme&, const J2Start<3>&,
                                   const StepKinematics<3>&, const ElasticTrial<3>&);
template StressByIncrement<2> consistent_moduli<2>(const J2Parameters&, const PointScheme&, const J2Start<2>&,
                                                   const StepKinematics<2>&, const ElasticTrial<2>&);
template StressByIncrement<3> consistent_moduli<3>(const J2Parameters&, const PointScheme&, const J2Start<3>&,
                                                   const StepKinematics<3>&, const ElasticTrial<3>&);
template PiolaTangent<2> consistent_tangent<2>(const J2Parameters&, const PointScheme&, const J2Start<2>&,
                                               const StepKinematics<2>&, const Gradient<2>&,
                                               const Stress<2>&);
template PiolaTangent<3> consistent_tangent<3>(const J2Parameters&, const PointScheme&, const J2Start<3>&,
                                               const StepKinematics<3>&, const Gradient<3>&,
                                               const Stress<3>&);
template PiolaTangent<2> rate_tangent<2>(const J2Parameters&, const Stress<2>&, double, const Gradient<2>&,
                                         bool, const double*);
template PiolaTangent<3> rate_tangent<3>(const J2Parameters&, const Stress<3>&, double, const Gradient<3>&,
                                         bool, const double*);

} // namespace burnish
