#include "material/j2/substepped_return.hpp"
#include <algorithm>

namespace burnish {

template <int Dim>
double substepped_return(const J2Parameters& material, const StrainPath<Dim>& path, int substeps,
                         Stress<Dim>& s, double& plastic_strain_eq) {
  const Stress<Dim> part = path.elastic_increment / substeps;
  double increment = 0;
  for (int k = 0; k < substeps; ++k) {
    const Stress<Dim> D = part + curvature_share(k, substeps) * path.curvature;
    increment += trapezoidal_return<Dim>(material, D, s, plastic_strain_eq).increment;
  }
  return increment;
}

template <int Dim>
double substepped_return(const J2Parameters& material, const StrainPath<Dim>& path,
                         const PathDerivative<Dim>& path_derivative, int substeps, Stress<Dim>& s,
                         double& plastic_strain_eq, ReturnDerivative<Dim>& derivative) {
  const Stress<Dim> part = path.elastic_increment / substeps;
  const StressByIncrement<Dim> part_by = path_derivative.elastic_increment / substeps;
  double increment = 0;
  for (int k = 0; k < substeps; ++k) {
    const double share = curvature_share(k, substeps);
    const Stress<Dim> D = part + share * path.curvature;
    const StressByIncrement<Dim> D_by = part_by + share * path_derivative.curvature;
    increment += trapezoidal_return<Dim>(material, D, D_by, s, plastic_strain_eq, derivative);
  }
  return increment;
}

template <int Dim>
int substeps_needed(const J2Parameters& material, const UpdateOptions& options,
                    const ElasticTrial<Dim>& trial, double plastic_strain_eq, bool plastic) {
  const double yield = material.yield_stress(plastic_strain_eq).value;
  if (!plastic && squared_equivalent<Dim>(trial.s_old + trial.elastic_increment) <= yield * yield) return 0;
  const double wanted = std::ceil(equivalent<Dim>(trial.elastic_increment) / (SUBSTEP_STRAIN * yield));
  if (std::isnan(wanted)) return 0; // the trial stress is NaN, which the caller reports
  // compared as doubles: a huge step must not overflow an int
  return static_cast<int>(
      std::clamp<double>(wanted, options.min_substeps, std::max(options.min_substeps, options.max_substeps)));
}

template double substepped_return<2>(const J2Parameters&, const StrainPath<2>&, int, Stress<2>&, double&);
template double substepped_return<3>(const J2Parameters&, const StrainPath<3>&, int, Stress<3>&, double&);
template double substepped_return<2>(const J2Parameters&, const StrainPath<2>&, const PathDerivative<2>&, int,
                                     Stress<2>&, double&, ReturnDerivative<2>&);
template double substepped_return<3>(const J2Parameters&, const StrainPath<3>&, const PathDerivative<3>&, int,
                                     Stress<3>&, double&, ReturnDerivative<3>&);
template int substeps_needed<2>(const J2Parameters&, const UpdateOptions&, const ElasticTrial<2>&, double,
                                bool);
template int substeps_needed<3>(const J2Parameters&, const UpdateOptions&, const ElasticTrial<3>&, double,
                                bool);

} // namespace burnish
