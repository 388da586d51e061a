#pragma once
// Gradients at a point as vectors: the part in the mesh's space and, in the plane, the stretch out of it. What Eigen
// does in space is compiled once, in gradient.cpp: this file is read nearly everywhere.
#include "material/point_traits.hpp"
#include <cmath>

namespace burnish {

/// The part in the mesh's space, row-major: all of it in space; in the plane without zz.
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

/// det F; in the plane negative also where both F_zz and the part in the plane are.
inline double determinant(const Gradient<2>& F) {
  const double det = (F[0] * F[3] - F[1] * F[2]) * F[4];
  return F[4] > 0 ? det : -std::abs(det);
}
double determinant(const Gradient<3>& F);

/// Change of the volume: ln det F, in small strains tr F - 3 [-]; METHOD.md (1.36).
template <int Dim> double volume_strain(const Gradient<Dim>& F, bool small_strain) {
  return small_strain ? undeformed<Dim>().dot(F) - 3 : std::log(determinant(F));
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
Gradient<3> inverse(const Gradient<3>& F);

inline Gradient<2> product(const Gradient<2>& a, const Gradient<2>& b) {
  Gradient<2> result;
  result[0] = a[0] * b[0] + a[1] * b[2];
  result[1] = a[0] * b[1] + a[1] * b[3];
  result[2] = a[2] * b[0] + a[3] * b[2];
  result[3] = a[2] * b[1] + a[3] * b[3];
  result[ZZ] = a[ZZ] * b[ZZ];
  return result;
}
Gradient<3> product(const Gradient<3>& a, const Gradient<3>& b);

} // namespace burnish
