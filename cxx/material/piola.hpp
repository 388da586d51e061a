#pragma once
// Push to the reference configuration: first Piola stress and its tangent (METHOD.md (1.3), (1.9)).
#include "material/gradient.hpp"
#include "material/stress_algebra.hpp"

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
Gradient<3> first_piola(const Stress<3>& stress, const Gradient<3>& F_inverse);

/// A = dP/dF, rows and columns in the order of Gradient.
template <int Dim>
using PiolaTangent = Eigen::Matrix<double, num_gradient<Dim>, num_gradient<Dim>, Eigen::RowMajor>;

/// d tau/dF, columns in the order of Gradient.
template <int Dim> using StressByF = Eigen::Matrix<double, num_stress<Dim>, num_gradient<Dim>>;

/// A_iJkL = (d tau_im/dF_kL) (F^-1)_Jm - P_iL (F^-1)_Jk, exact, not symmetrized.
template <int Dim>
PiolaTangent<Dim> piola_tangent(const StressByF<Dim>& stress_by_F, const Stress<Dim>& stress,
                                const Gradient<Dim>& F_inverse) {
  const Gradient<Dim> P = first_piola(stress, F_inverse);
  PiolaTangent<Dim> A;
  for (int c = 0; c < num_gradient<Dim>; ++c)
    A.col(c) = first_piola(Stress<Dim>(stress_by_F.col(c)), F_inverse);
  for (int i = 0; i < Dim; ++i)
    for (int J = 0; J < Dim; ++J)
      for (int k = 0; k < Dim; ++k)
        for (int L = 0; L < Dim; ++L) A(Dim * i + J, Dim * k + L) -= P[Dim * i + L] * F_inverse[Dim * J + k];
  if constexpr (PointTraits<Dim>::has_hoop) A(ZZ, ZZ) -= P[ZZ] * F_inverse[ZZ];
  return A;
}

/// F^-1 as P = tau F^-T takes it: I in small strains, METHOD.md 1.15.
template <int Dim> Gradient<Dim> pull_back(const Gradient<Dim>& F, bool small_strain) {
  return small_strain ? undeformed<Dim>() : inverse(F);
}
/// piola_tangent at F, in small strains without the term of the turned areas.
template <int Dim>
PiolaTangent<Dim> piola_tangent(const StressByF<Dim>& stress_by_F, const Stress<Dim>& stress,
                                const Gradient<Dim>& F, bool small_strain) {
  const Stress<Dim> turned = small_strain ? Stress<Dim>::Zero() : stress;
  return piola_tangent<Dim>(stress_by_F, turned, pull_back<Dim>(F, small_strain));
}

} // namespace burnish
