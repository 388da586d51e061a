#pragma once
// Algebra of symmetric tensors kept as Stress<Dim> (tensor shear components): contraction, deviator, rotation.
#include "material/point_traits.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {

/// Derivative of stress components with respect to a step's increments.
template <int Dim> using StressByIncrement = Eigen::Matrix<double, num_stress<Dim>, num_increments<Dim>>;
/// Derivative of a scalar with respect to them.
template <int Dim> using ScalarByIncrement = Eigen::Matrix<double, 1, num_increments<Dim>>;

/// Derivative of the strains with respect to the increments: zeros in the columns of the rotations.
template <int Dim> StressByIncrement<Dim> strain_by_increment() { return StressByIncrement<Dim>::Identity(); }

/// Mean tr(t)/3.
template <int Dim> double mean(const Stress<Dim>& t) { return (t[0] + t[1] + t[2]) / 3; }

/// t - mean(t) I.
template <int Dim> Stress<Dim> deviator(const Stress<Dim>& t) {
  Stress<Dim> s = t;
  s.template head<3>().array() -= mean<Dim>(t);
  return s;
}

/// a:b, every shear entry counted twice.
template <int Dim> double contract(const Stress<Dim>& a, const Stress<Dim>& b) {
  double sum = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  for (int k = 3; k < num_stress<Dim>; ++k) sum += 2 * a[k] * b[k];
  return sum;
}

/// Row r with r.b = a:b (shear entries doubled).
template <int Dim> Eigen::Matrix<double, 1, num_stress<Dim>> contraction_row(const Stress<Dim>& a) {
  Eigen::Matrix<double, 1, num_stress<Dim>> row = a.transpose();
  for (int k = 3; k < num_stress<Dim>; ++k) row[k] *= 2;
  return row;
}

/// q^2 = 3/2 s:s and q of a deviator s (von Mises stress).
template <int Dim> double squared_equivalent(const Stress<Dim>& s) { return 1.5 * contract<Dim>(s, s); }
template <int Dim> double equivalent(const Stress<Dim>& s) { return std::sqrt(squared_equivalent<Dim>(s)); }

/// The part in the mesh's space as a matrix: all of it in space; in the plane without zz.
template <int Dim> Tensor<Dim> matrix_of(const Stress<Dim>& t) {
  Tensor<Dim> T;
  for (int k = 0; k < num_stress<Dim>; ++k) {
    const auto [i, j] = PointTraits<Dim>::place[k];
    if (i >= 0) T(i, j) = T(j, i) = t[k];
  }
  return T;
}

/// The symmetric part of a matrix in space.
template <class Matrix> Stress<3> stress_of(const Eigen::MatrixBase<Matrix>& T) {
  const Tensor<3> M = T;
  Stress<3> t;
  t << M(0, 0), M(1, 1), M(2, 2), 0.5 * (M(0, 1) + M(1, 0)), 0.5 * (M(1, 2) + M(2, 1)),
      0.5 * (M(2, 0) + M(0, 2));
  return t;
}

/// Largest and smallest principal stress [stress].
inline std::array<double, 2> extreme_principals(const Stress<2>& t) {
  const double middle = 0.5 * (t[0] + t[1]), radius = std::hypot(0.5 * (t[0] - t[1]), t[3]);
  return {std::max(middle + radius, t[2]), std::min(middle - radius, t[2])};
}
std::array<double, 2> extreme_principals(const Stress<3>& t);

/// R t R' for a rotation by the angle alpha in the plane, counter-clockwise positive; zz does not change.
/// @param cos_2alpha, sin_2alpha of twice the angle
inline Stress<2> rotated(const Stress<2>& t, double cos_2alpha, double sin_2alpha) {
  const double middle = 0.5 * (t[0] + t[1]), half = 0.5 * (t[0] - t[1]);
  const double turned = cos_2alpha * half - sin_2alpha * t[3];
  return {middle + turned, middle - turned, t[2], sin_2alpha * half + cos_2alpha * t[3]};
}

/// R t R' in space. @param R rotation
Stress<3> rotated(const Stress<3>& t, const Tensor<3>& R);

/// Rate of R t R' per unit of the angle: w t - t w with w_21 = 1.
inline Stress<2> spin_rate(const Stress<2>& t) { return {-2 * t[3], 2 * t[3], 0, t[0] - t[1]}; }
/// The same per unit of the spins about x, y, z, one column each.
Eigen::Matrix<double, 6, 3> spin_rate(const Stress<3>& t);

} // namespace burnish
