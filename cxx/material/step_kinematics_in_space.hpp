#pragma once
// Kinematics of a step at a point in space: as step_kinematics.hpp, with a rotation about any axis (METHOD.md 1.16).
#include "material/step_kinematics.hpp"

namespace burnish {

template <> struct StepKinematics<3> {
  StrainFrame frame = StrainFrame::MIDPOINT;
  CorotationalRate rate = CorotationalRate::JAUMANN;
  Gradient<3> G;                            ///< midpoint gradient dF F_mid^-1 [-]
  Gradient<3> F_mid_inverse;                ///< inverse of F_mid = (F_old + F)/2 [-]
  double det_mid = 0;                       ///< determinant(F_mid); the rest is set only if it is > 0
  Stress<3> strain;                         ///< dd = sym G, in its frame [-]
  Vector<3> spin = Vector<3>::Zero();       ///< axial vector of the skew part of G [-]
  Tensor<3> R = Tensor<3>::Identity();      ///< rotation of the rate
  Tensor<3> R_half = Tensor<3>::Identity(); ///< by half its angle about the same axis
  Vector<3> excess = Vector<3>::Zero();     ///< LOGARITHMIC only: rotation vector of METHOD.md (1.39)
  Gradient<3> F = Gradient<3>::Zero(),
              F_mid = F; ///< end and middle of the step; not set for SMALL_STRAIN [-]
};

/// R t R' with the rotation of the step.
inline Stress<3> rotated(const Stress<3>& t, const StepKinematics<3>& kin) { return rotated(t, kin.R); }

/// From F_old to F in one step. A rigid rotation by any angle below pi gives dd = 0 and R = that rotation, with every rate.
/// With StrainFrame::END, dd = R_half sym(G) R_half', METHOD.md (1.14).
/// Never throws: where det_mid is not > 0 the other members are not set.
StepKinematics<3> step_kinematics(const Gradient<3>& F_old, const Gradient<3>& F, StrainFrame frame,
                                  CorotationalRate rate = CorotationalRate::JAUMANN);

/// Exact linearization of the finite step: the strains, then the spins about x, y, z of dR R'.
IncrementByF<3> finite_increment_by_F(const StepKinematics<3>& kin);

/// y of a step and dy/dF. @param kin det_mid > 0
StepIncrements<3> increments_of(const StepKinematics<3>& kin);

/// Rates at the configuration F: L = dF F^-1, y = (strain rates, spin of the rate about x, y, z); the limit of a
/// vanishing step. @param F_inverse of F
IncrementByF<3> rate_by_F(const Gradient<3>& F, const Gradient<3>& F_inverse, CorotationalRate rate);

} // namespace burnish
