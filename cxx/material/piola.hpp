#pragma once
// Push to the reference configuration: first Piola stress and its tangent (method.md section 1).
#include "material/step_kinematics.hpp"

namespace burnish {

/// P = tau F^-T, P_iJ = tau_im (F^-1)_Jm, in the order of Gradient [stress]; force = sum V0 P_iJ dN/dX_J, and
/// in axisymmetry P_zz N/R in the radial component.
inline Gradient<2> first_piola(const Stress<2>& stress, const Gradient<2>& F_inverse) {
  const Gradient<2>& g = F_inverse;
  Gradient<2> P;
  P[0] = stress[0] * g[0] + stress[3] * g[1];
  P[1] = stress[0] * g[2] + stress[3] * g[3];
  P[2] = stress[3] * g[0] + stress[1] * g[1];
  P[3] = stress[3] * g[2] + stress[1] * g[3];
  P[ZZ] = stress[2] * g[ZZ];
  return P;
}

/// A = dP/dF, rows and columns in the order of Gradient.
template <int Dim>
using PiolaTangent = Eigen::Matrix<double, num_gradient<Dim>, num_gradient<Dim>, Eigen::RowMajor>;

/// d tau/dF, columns in the order of Gradient.
template <int Dim> using StressByF = Eigen::Matrix<double, num_stress<Dim>, num_gradient<Dim>>;

/// A_iJkL = (d tau_im/dF_kL) (F^-1)_Jm - P_iL (F^-1)_Jk, exact, not symmetrized.
inline PiolaTangent<2> piola_tangent(const StressByF<2>& stress_by_F, const Stress<2>& stress,
                                     const Gradient<2>& F_inverse) {
  const Gradient<2> P = first_piola(stress, F_inverse);
  PiolaTangent<2> A;
  for (int c = 0; c < 5; ++c) A.col(c) = first_piola(stress_by_F.col(c), F_inverse);
  for (int i = 0; i < 2; ++i)
    for (int J = 0; J < 2; ++J)
      for (int k = 0; k < 2; ++k)
        for (int L = 0; L < 2; ++L) A(2 * i + J, 2 * k + L) -= P[2 * i + L] * F_inverse[2 * J + k];
  A(ZZ, ZZ) -= P[ZZ] * F_inverse[ZZ];
  return A;
}

} // namespace burnish
