#pragma once
// Push to the reference configuration: first Piola stress and its tangent (method.md section 1).
#include "material/step_kinematics.hpp"

namespace burnish {

/// Symmetric tensor of the in-plane components.
inline Tensor<2> in_plane(const Stress<2>& stress) {
  Tensor<2> t;
  t << stress[0], stress[3], stress[3], stress[1];
  return t;
}

/// P = tau F^-T, P_iJ = tau_im (F^-1)_Jm [stress]; force = sum V0 P_iJ dN/dX_J.
inline Tensor<2> first_piola(const Stress<2>& stress, const Tensor<2>& F_inverse) {
  return in_plane(stress) * F_inverse.transpose();
}

/// A_iJkL = dP_iJ/dF_kL, row 2i + J, column 2k + L: in the plane acts on [du/dX, du/dY, dv/dX, dv/dY].
template <int Dim> using PiolaTangent = Eigen::Matrix<double, Dim * Dim, Dim * Dim, Eigen::RowMajor>;

/// A_iJkL = (d tau_im/dF_kL) (F^-1)_Jm - P_iL (F^-1)_Jk, exact, not symmetrized.
/// @param stress_by_F d tau/dF, num_stress x Dim*Dim, columns k*Dim + L [stress]
inline PiolaTangent<2> piola_tangent(const StressByIncrement<2>& stress_by_F, const Stress<2>& stress,
                                     const Tensor<2>& F_inverse) {
  const Tensor<2> P = first_piola(stress, F_inverse);
  const int component[2][2] = {{0, 3}, {3, 1}}; // of tau_im
  PiolaTangent<2> A;
  for (int i = 0; i < 2; ++i)
    for (int J = 0; J < 2; ++J) {
      A.row(2 * i + J) = F_inverse(J, 0) * stress_by_F.row(component[i][0]) +
                         F_inverse(J, 1) * stress_by_F.row(component[i][1]);
      for (int k = 0; k < 2; ++k)
        for (int L = 0; L < 2; ++L) A(2 * i + J, 2 * k + L) -= P(i, L) * F_inverse(J, k);
    }
  return A;
}

} // namespace burnish
