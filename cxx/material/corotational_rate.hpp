#pragma once
// The corotational rate in which a law is written: by which angle stress and internal tensors turn in a step (METHOD.md
// 1.10). In the plane every corotational rate is a rotation by one angle.
#include "material/gradient.hpp"
#include "material/stress_algebra.hpp"
#include <string>

namespace burnish {

enum class CorotationalRate {
  JAUMANN,      ///< spin w, the skew part of the velocity gradient; the step's angle by [HughesWinget1980]
  GREEN_NAGHDI, ///< spin of the rotation R of F = R U [Dienes1979]
  LOGARITHMIC,  ///< the spin in which the rate of ln V is d [XiaoBruhnsMeyers1997]
  SMALL_STRAIN, ///< none turns, and all gradients are by the undeformed place, METHOD.md 1.15; no name of a rate
};
/// By its name in a script: jaumann, greennaghdi, logarithmic.
/// @throws std::invalid_argument "where: ..." for another name (lists them)
CorotationalRate corotational_rate(const std::string& name, const char* where);

/// A rotation in the plane, counter-clockwise positive.
struct PlaneRotation {
  double cos = 1, sin = 0;
};
inline PlaneRotation operator*(const PlaneRotation& a, const PlaneRotation& b) {
  return {a.cos * b.cos - a.sin * b.sin, a.sin * b.cos + a.cos * b.sin};
}

/// Derivative of an angle and of a strain by F, columns in the order of Gradient.
using AngleByF = Eigen::Matrix<double, 1, num_gradient<2>>;
using StrainByF = Eigen::Matrix<double, num_stress<2>, num_gradient<2>>;

/// R(F) R(F_old)' of the polar decompositions F = R U, METHOD.md (1.19). @param F_old, F determinant > 0
PlaneRotation polar_rotation(const Gradient<2>& F_old, const Gradient<2>& F);
/// Derivative of the angle of R(F) [1/F]. @param F determinant > 0
AngleByF polar_angle_by_F(const Gradient<2>& F);

/// What the logarithmic spin has more than w for the strain (rate) d at F, METHOD.md (1.20): component 21, linear in d.
/// Zero for d = 0, so a rigid rotation stays exact. @param F determinant > 0; @param d strain in the frame of F
double logarithmic_excess(const Gradient<2>& F, const Stress<2>& d);
/// Its derivative. @param d_by_F of d; @param share dF_at/dF of the place where F is taken: 1/2 for the middle of a step
AngleByF logarithmic_excess_by_F(const Gradient<2>& F, const Stress<2>& d, const StrainByF& d_by_F,
                                 double share);

} // namespace burnish
