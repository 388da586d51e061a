#pragma once
// Trapezoidal return in equal substeps along a strain path (ALGORITHMS.md 2).
#include "material/j2/trapezoidal_return.hpp"
#include "material/strain_path.hpp"

namespace burnish {

/// Runs the n substeps st = s + elastic_increment/n + share_k curvature, each returned by the trapezoidal rule.
/// (ALGORITHMS.md (2.3) writes the same with w_q = b curvature_share(k, n), w_d = 1/n + w_q.)
/// @param s deviator R s_old R' in, deviator at the end of the step out [stress]
/// @param plastic_strain_eq ep in and out [-]
/// @return accumulated plastic increment >= 0
template <int Dim>
double substepped_return(const J2Parameters& material, const StrainPath<Dim>& path, int substeps,
                         Stress<Dim>& s, double& plastic_strain_eq);

/// The same with the exact derivative; `derivative` enters as that of R s_old R' and of ep_old.
template <int Dim>
double substepped_return(const J2Parameters& material, const StrainPath<Dim>& path,
                         const PathDerivative<Dim>& path_derivative, int substeps, Stress<Dim>& s,
                         double& plastic_strain_eq, ReturnDerivative<Dim>& derivative);

/// Number of substeps a step asks for: max(min_substeps, ceil(q(De)/(substep_strain sigma_y))), at most
/// max_substeps; 0 if the step is elastic: trial of the straight path inside the surface, no flow last step.
/// @param plastic_strain_eq, plastic  ep and plastic flag at the start of the step
template <int Dim>
int substeps_needed(const J2Parameters& material, const UpdateOptions& options,
                    const ElasticTrial<Dim>& trial, double plastic_strain_eq, bool plastic);

} // namespace burnish
