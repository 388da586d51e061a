#pragma once
// One step of one quadrature point: stress at its end, and the tangent of the first Piola stress. Pure
// functions.
#include "material/piola.hpp"
#include "material/substepped_return.hpp"

namespace burnish {

/// A point at the start of the step.
template <int Dim> struct PointOld {
  Gradient<Dim> F;              ///< deformation gradient [-]
  Stress<Dim> stress;           ///< Kirchhoff stress [stress]
  double plastic_strain_eq = 0; ///< ep [-]
  Stress<Dim> strain_increment; ///< of the step that ended here [-]
  bool plastic = false;         ///< plastic flow happened in that step
};

/// The same point at the end of the step.
template <int Dim> struct PointNew {
  Stress<Dim> stress;
  double plastic_strain_eq = 0;
  bool plastic = false; ///< plastic flow happened in this step
};

/// How the step is made at this point.
struct PointScheme {
  StressUpdate update = StressUpdate::SUBSTEPPED;
  double path_limit = 1.5; ///< L
  double ratio = 0;        ///< ra = dt/dt_old, 0: no last step
  int substeps = 0;        ///< SUBSTEPPED only: number of substeps, 0: elastic step
};

/// tau = R tau_old R' + E:dd returned to the yield surface, or forward Euler of (3.1) which does not return.
/// @param kin of the step, det_mid > 0; @param trial elastic_trial(material, kin, old.stress)
template <int Dim>
PointNew<Dim> updated_point(const J2Parameters& material, const PointScheme& scheme, const PointOld<Dim>& old,
                            const StepKinematics<Dim>& kin, const ElasticTrial<Dim>& trial);

/// d tau/dy of updated_point, exact: the chain of algorithms.md section 2 through all substeps, here directly
/// for the increments y of step_kinematics.hpp instead of MA and MB.
template <int Dim>
StressByIncrement<Dim> consistent_moduli(const J2Parameters& material, const PointScheme& scheme,
                                         const PointOld<Dim>& old, const StepKinematics<Dim>& kin,
                                         const ElasticTrial<Dim>& trial);

/// A_iJkL = dP_iJ/dF_kL of updated_point, exact, slightly nonsymmetric [stress].
/// @param kin of the step from old.F to F; @param stress of updated_point [stress]
template <int Dim>
PiolaTangent<Dim> consistent_tangent(const J2Parameters& material, const PointScheme& scheme,
                                     const PointOld<Dim>& old, const StepKinematics<Dim>& kin,
                                     const Gradient<Dim>& F, const Stress<Dim>& stress);

/// Tangent of the rates (1.11) on the reference mesh, symmetric [stress]:
/// with dF = L F, dF:dP = dL_ij (D:d + w tau - tau d)_ij.
/// (The article writes D:d - d.tau - tau.w: its double dot pairs dL_ij with the transpose.)
/// @param plastic true: D of (3.1) loading; false: elastic moduli, same geometric terms
template <int Dim>
PiolaTangent<Dim> rate_tangent(const J2Parameters& material, const Stress<Dim>& stress,
                               const Gradient<Dim>& F, bool plastic);

} // namespace burnish
