#pragma once
// One step of one quadrature point with J2: stress at its end, and the tangent of the first Piola stress.
// Pure functions.
#include "material/j2/substepped_return.hpp"
#include "material/piola.hpp"

namespace burnish {

/// What the update takes from the start of the step.
template <int Dim> struct J2Start {
  Eigen::Map<const Stress<Dim>> stress;           ///< tau [stress]; the turned one is in the trial
  double plastic_strain_eq = 0;                   ///< ep [-]
  Eigen::Map<const Stress<Dim>> strain_increment; ///< dd_p of the step that ended here [-]
  bool plastic = false; ///< on the surface: plastic flow happened in that step, or by an event
  const double* backstress =
      nullptr; ///< X in the order of Stress<Dim>; read where material.kinematic exists() [stress]
};

/// What it gives.
template <int Dim> struct J2End {
  Stress<Dim> stress;           ///< Kirchhoff stress [stress]
  double plastic_strain_eq = 0; ///< ep [-]
  bool plastic = false;         ///< plastic flow happened in this step
  Stress<Dim> backstress = {};  ///< X; set where material.kinematic exists() [stress]
};

/// How the step is made at this point.
struct PointScheme {
  StressUpdate update = StressUpdate::SUBSTEPPED;
  double path_limit = 1.5; ///< L
  double ratio = 0;        ///< ra = dt/dt_old, 0: no last step
  int substeps = 0;        ///< SUBSTEPPED only: number of substeps, 0: elastic step
};
/// Substeps of its return: SINGLE is one, in which the curvature of the path has no share.
inline int substeps_of(const PointScheme& scheme) {
  return scheme.update == StressUpdate::SINGLE ? 1 : scheme.substeps;
}
template <int Dim> PathHistory<Dim> history_of(const PointScheme& scheme, const J2Start<Dim>& old) {
  return {old.strain_increment, scheme.ratio, scheme.path_limit};
}

/// tau = R tau_old R' + E:dd returned to the yield surface, or forward Euler of METHOD.md (1.6) which does not return.
/// @param kin of the step, det_mid > 0; @param trial elastic_trial(material.elastic, kin, old stress)
template <int Dim>
J2End<Dim> updated_point(const J2Parameters& material, const PointScheme& scheme, const J2Start<Dim>& old,
                         const StepKinematics<Dim>& kin, const ElasticTrial<Dim>& trial);

/// d tau/dy of updated_point, exact: the chain rule of METHOD.md (1.15), (1.35) through all substeps, here directly
/// for the increments y of step_kinematics.hpp instead of MA and MB.
template <int Dim>
StressByIncrement<Dim> consistent_moduli(const J2Parameters& material, const PointScheme& scheme,
                                         const J2Start<Dim>& old, const StepKinematics<Dim>& kin,
                                         const ElasticTrial<Dim>& trial);

/// A_iJkL = dP_iJ/dF_kL of updated_point, exact, slightly nonsymmetric [stress].
/// @param kin of the step to F; @param stress of updated_point [stress]
template <int Dim>
PiolaTangent<Dim> consistent_tangent(const J2Parameters& material, const PointScheme& scheme,
                                     const J2Start<Dim>& old, const StepKinematics<Dim>& kin,
                                     const Gradient<Dim>& F, const Stress<Dim>& stress);

/// Tangent of the rates, METHOD.md (1.8), on the reference mesh, with the spin of material.rate; symmetric for JAUMANN
/// [stress]:
/// with dF = L F, dF:dP = dL_ij (D:d + w tau - tau d)_ij.
/// (The article writes D:d - d.tau - tau.w: its double dot pairs dL_ij with the transpose.)
/// @param plastic true: D of METHOD.md (1.6) loading; false: elastic moduli, same geometric terms
/// @param backstress X where material.kinematic exists() [stress]
template <int Dim>
PiolaTangent<Dim> rate_tangent(const J2Parameters& material, const Stress<Dim>& stress,
                               double plastic_strain_eq, const Gradient<Dim>& F, bool plastic,
                               const double* backstress = nullptr);

} // namespace burnish
