#pragma once
// The cross product as a matrix, and back.
#include "base/types.hpp"

namespace burnish {

/// The matrix of a cross product: cross_matrix(v) x = v x x.
inline Tensor<3> cross_matrix(const Vector<3>& v) {
  Tensor<3> M;
  M << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return M;
}

/// The vector v of the skew part of T: cross_matrix(v) = (T - T')/2.
template <class Matrix> Vector<3> axial_vector(const Eigen::MatrixBase<Matrix>& T) {
  return 0.5 * Vector<3>(T(2, 1) - T(1, 2), T(0, 2) - T(2, 0), T(1, 0) - T(0, 1));
}

} // namespace burnish
