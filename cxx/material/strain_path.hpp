#pragma once
// The strain path inside a step: straight, or quadratic through the mean rates of the last and the present
// step (ALGORITHMS.md 2).
#include "material/elastic.hpp"

namespace burnish {

/// e(f) = f dd + (b/2) f (f-1) (dd - ra dd_p), f = 0..1, as deviatoric stress:
/// f elastic_increment + (1/2) f (f-1) curvature.
template <int Dim> struct StrainPath {
  Stress<Dim> elastic_increment; ///< 2G dev(dd) [stress]
  Stress<Dim> curvature;         ///< 2G dev(b (dd - ra dd_p)), zero for a straight path [stress]
};
/// Its derivative with respect to the step's increments.
template <int Dim> struct PathDerivative { StressByIncrement<Dim> elastic_increment, curvature; };

/// Where the last step's mean rate comes from.
template <int Dim> struct PathHistory {
  Stress<Dim> strain_old; ///< dd_p, strain increment of the last step [-]
  double ratio = 0;       ///< ra = dt/dt_old; 0: no last step, the path is straight
  double limit = 0; ///< L: b shrinks to b L |dd|/|dd - ra dd_p| where |dd - ra dd_p| > L |dd|; 0: straight
};

/// Part of f(f-1)/2 that falls on substep k of n: [f1(f1-1) - f0(f0-1)]/2; the parts sum to zero, so the
/// end point of the path is exact.
inline double curvature_share(int k, int n) {
  const double step = 1.0 / n;
  return 0.5 * step * ((2 * k + 1) * step - 1);
}

/// StrainFrame::END turns dd_p by the step's rotation together with the old stress (ALGORITHMS.md 2);
/// StrainFrame::MIDPOINT leaves it, and a spin curves the path.
/// @param elastic_increment 2G dev(dd) [stress]
/// @param derivative filled unless null; exact, the limiter's dependence on dd included
template <int Dim>
StrainPath<Dim> strain_path(const ElasticModuli& elastic, const StepKinematics<Dim>& kin,
                            const Stress<Dim>& elastic_increment, const PathHistory<Dim>& history,
                            PathDerivative<Dim>* derivative);

} // namespace burnish
