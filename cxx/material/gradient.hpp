#pragma once
// Gradients at a point as vectors: the part in the mesh's space and, in the plane, the stretch out of it.
#include "base/types.hpp"
#include <cmath>

namespace burnish {

/// Components of a gradient kept at a point. Dim 2: xx, xy, yx, yy, zz; F_zz is 1 in plane strain and
/// 1 + u_r/R in axisymmetry (x = r, y along the axis, zz = hoop, R the reference radius). Dim 3: row-major.
template <int Dim> inline constexpr int num_gradient = Dim == 2 ? 5 : 9;
template <int Dim> using Gradient = Eigen::Matrix<double, num_gradient<Dim>, 1>;
inline constexpr int ZZ = 4; ///< place of the zz component, Dim 2
/// The part in the mesh's space, row-major.
template <int Dim> using RowMajorTensor = Eigen::Matrix<double, Dim, Dim, Eigen::RowMajor>;
template <int Dim> Eigen::Map<const RowMajorTensor<Dim>> mesh_part(const Gradient<Dim>& F) {
  return Eigen::Map<const RowMajorTensor<Dim>>(F.data());
}
template <int Dim> Eigen::Map<RowMajorTensor<Dim>> mesh_part(Gradient<Dim>& F) {
  return Eigen::Map<RowMajorTensor<Dim>>(F.data());
}

/// F of the undeformed body.
template <int Dim> Gradient<Dim> undeformed() {
  Gradient<Dim> F = Gradient<Dim>::Ones();
  mesh_part<Dim>(F).setIdentity();
  return F;
}

/// det F; negative also where both F_zz and the part in the plane are.
inline double determinant(const Gradient<2>& F) {
  const double det = (F[0] * F[3] - F[1] * F[2]) * F[4];
  return F[4] > 0 ? det : -std::abs(det);
}

/// det F' F^-1, F' the part in the plane.
inline Gradient<2> adjugate(const Gradient<2>& F) {
  Gradient<2> result;
  result[0] = F[3];
  result[1] = -F[1];
  result[2] = -F[2];
  result[3] = F[0];
  result[ZZ] = (F[0] * F[3] - F[1] * F[2]) / F[ZZ];
  return result;
}
inline Gradient<2> inverse(const Gradient<2>& F) { return 1 / (F[0] * F[3] - F[1] * F[2]) * adjugate(F); }

inline Gradient<2> product(const Gradient<2>& a, const Gradient<2>& b) {
  Gradient<2> result;
  result[0] = a[0] * b[0] + a[1] * b[2];
  result[1] = a[0] * b[1] + a[1] * b[3];
  result[2] = a[2] * b[0] + a[3] * b[2];
  result[3] = a[2] * b[1] + a[3] * b[3];
  result[ZZ] = a[ZZ] * b[ZZ];
  return result;
}

} // namespace burnish
