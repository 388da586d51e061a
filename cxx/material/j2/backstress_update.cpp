#include "material/j2/backstress_update.hpp"
#include "material/j2/rate_law.hpp"

namespace burnish {
namespace {

template <int Dim>
StrainPath<Dim> path_of(const J2Parameters& material, const PointScheme& scheme, const J2Start<Dim>& old,
                        const StepKinematics<Dim>& kin, const ElasticTrial<Dim>& trial,
                        PathDerivative<Dim>* derivative) {
  return strain_path<Dim>(material.elastic, kin, trial.elastic_increment, history_of(scheme, old),
                          derivative);
}

// Forward Euler step of METHOD.md (1.6): with n = xi/q, s += 2G dev(dd) - 3G x n, X += x (C n - gamma X).
template <int Dim>
double forward_euler(const J2Parameters& material, const StepKinematics<Dim>& kin,
                     const Stress<Dim>& elastic_increment, bool yielded, J2End<Dim>& end) {
  Stress<Dim>&s = end.stress, &X = end.backstress;
  const Stress<Dim> xi = s - X;
  s += elastic_increment;
  if (!loads<Dim>(material, xi, end.plastic_strain_eq, kin.strain, yielded)) return 0;
  const double moving = kinematic_modulus<Dim>(material.kinematic, xi, X), q = equivalent<Dim>(xi);
  const double power = contract<Dim>(xi, kin.strain), G3 = 3 * material.elastic.G;
  const double c = plastic_factor<Dim>(material, xi, end.plastic_strain_eq, moving);
  const double x = c * q * power / G3; // METHOD.md (1.7), (1.25)
  s -= c * power * xi;
  X += x * (material.kinematic.modulus / q * xi - material.kinematic.recovery * X);
  end.plastic_strain_eq += x;
  return x;
}

template <int Dim>
StressByIncrement<Dim> forward_euler_by_increment(const J2Parameters& material,
                                                  const StepKinematics<Dim>& kin, const J2Start<Dim>& old,
                                                  const Stress<Dim>& s, const Stress<Dim>& X) {
  StressByIncrement<Dim> by = deviatoric_moduli<Dim>(material.elastic);
  by.template rightCols<PointTraits<Dim>::num_rotations>() += spin_rate(s);
  const Stress<Dim> xi = s - X;
  if (!loads<Dim>(material, xi, old.plastic_strain_eq, kin.strain, old.plastic)) return by;
  // c (xi:dd) xi with c unchanged by the rotation
  const double c = plastic_factor<Dim>(material, xi, old.plastic_strain_eq,
                                       kinematic_modulus<Dim>(material.kinematic, xi, X));
  StressByIncrement<Dim> xi_by = StressByIncrement<Dim>::Zero();
  xi_by.template rightCols<PointTraits<Dim>::num_rotations>() = spin_rate(xi);
  const ScalarByIncrement<Dim> power_by =
      contraction_row<Dim>(xi) * strain_by_increment<Dim>() + contraction_row<Dim>(kin.strain) * xi_by;
  by.noalias() -= c * xi * power_by;
  by -= c * contract<Dim>(xi, kin.strain) * xi_by;
  return by;
}

} // namespace

template <int Dim>
J2End<Dim> updated_with_backstress(const J2Parameters& material, const PointScheme& scheme,
                                   const J2Start<Dim>& old, const StepKinematics<Dim>& kin,
                                   const ElasticTrial<Dim>& trial) {
  J2End<Dim> result{trial.s_old, old.plastic_strain_eq, false, turned_backstress(old, kin)};
  Stress<Dim>&s = result.stress, &X = result.backstress;
  const int substeps = substeps_of(scheme);
  double increment = 0;
  if (scheme.update == StressUpdate::FORWARD_EULER) {
    increment = forward_euler<Dim>(material, kin, trial.elastic_increment, old.plastic, result);
  } else if (substeps == 0) {
    s += trial.elastic_increment;
  } else {
    const StrainPath<Dim> path = path_of<Dim>(material, scheme, old, kin, trial, nullptr);
    const Stress<Dim> part = path.elastic_increment / substeps;
    for (int k = 0; k < substeps; ++k) {
      s += part + curvature_share(k, substeps) * path.curvature;
      increment += backstress_return<Dim>(material, s, result.plastic_strain_eq, X);
    }
  }
  result.plastic = increment > 0;
  s.template head<3>().array() += trial.mean;
  return result;
}

template <int Dim>
StressByIncrement<Dim> moduli_with_backstress(const J2Parameters& material, const PointScheme& scheme,
                                              const J2Start<Dim>& old, const StepKinematics<Dim>& kin,
                                              const ElasticTrial<Dim>& trial) {
  Stress<Dim> s = trial.s_old, X = turned_backstress(old, kin);
  BackstressDerivative<Dim> derivative;
  derivative.s.template rightCols<PointTraits<Dim>::num_rotations>() = spin_rate(s);
  derivative.backstress.template rightCols<PointTraits<Dim>::num_rotations>() = spin_rate(X);
  double plastic_strain_eq = old.plastic_strain_eq;
  const int substeps = substeps_of(scheme);
  if (scheme.update == StressUpdate::FORWARD_EULER) {
    derivative.s = forward_euler_by_increment<Dim>(material, kin, old, s, X);
  } else if (substeps == 0) {
    derivative.s += deviatoric_moduli<Dim>(material.elastic);
  } else {
    PathDerivative<Dim> path_by;
    const StrainPath<Dim> path = path_of<Dim>(material, scheme, old, kin, trial, &path_by);
    const Stress<Dim> part = path.elastic_increment / substeps;
    const StressByIncrement<Dim> part_by = path_by.elastic_increment / substeps;
    for (int k = 0; k < substeps; ++k) {
      const double share = curvature_share(k, substeps);
      s += part + share * path.curvature;
      derivative.s += part_by + share * path_by.curvature;
      backstress_return<Dim>(material, s, plastic_strain_eq, X, derivative);
    }
  }
  derivative.s.template topLeftCorner<3, 3>().array() += material.elastic.K;
  return derivative.s;
}

template J2End<2> updated_with_backstress<2>(const J2Parameters&, const PointScheme&, const J2Start<2>&,
                                             const StepKinematics<2>&, const ElasticTrial<2>&);
template J2End<3> updated_with_backstress<3>(const J2Parameters&, const PointScheme&, const J2Start<3>&,
                                             const StepKinematics<3>&, const ElasticTrial<3>&);
template StressByIncrement<2> moduli_with_backstress<2>(const J2Parameters&, const PointScheme&,
                                                        const J2Start<2>&, const StepKinematics<2>&,
                                                        const ElasticTrial<2>&);
template StressByIncrement<3> moduli_with_backstress<3>(const J2Parameters&, const PointScheme&,
                                                        const J2Start<3>&, const StepKinematics<3>&,
                                                        const ElasticTrial<3>&);

} // namespace burnish
