#pragma once
// The rotations and spins of the corotational rates in space (METHOD.md 1.16).
#include "material/corotational_rate.hpp"

namespace burnish {

/// Derivative of a spin and of a strain by F, columns in the order of Gradient.
using SpinByF3 = Eigen::Matrix<double, 3, num_gradient<3>>;
using StrainByF3 = Eigen::Matrix<double, num_stress<3>, num_gradient<3>>;

/// R of F = R U. @param F determinant > 0
Tensor<3> polar_rotation(const Gradient<3>& F);
/// Spins about x, y, z of dR R' [1/F], METHOD.md (1.40). @param F determinant > 0
SpinByF3 polar_spin_by_F(const Gradient<3>& F);

/// What the logarithmic spin has more than w for the strain (rate) d at F, METHOD.md (1.39), as axial vector, linear in
/// d. @param F determinant > 0; @param d strain in the frame of F
Vector<3> logarithmic_excess(const Gradient<3>& F, const Stress<3>& d);
/// Its derivative. @param d_by_F of d; @param share dF_at/dF of the place where F is taken: 1/2 for the middle of a step
SpinByF3 logarithmic_excess_by_F(const Gradient<3>& F, const Stress<3>& d, const StrainByF3& d_by_F,
                                 double share);

/// Spins of dR R' per change of the rotation vector v of R.
Tensor<3> rotation_vector_tangent(const Vector<3>& v);

} // namespace burnish
