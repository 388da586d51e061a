#pragma once
// Gradients and stresses of the plane put into a plane of space, and rotations about any axis.
#include "unit/material/j2/point_walk.hpp"
#include <Eigen/Geometry>

namespace burnish::test {

inline Tensor<3> turn_about(const Vector<3>& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}
inline Gradient<3> gradient_of(const Tensor<3>& T) {
  Gradient<3> F;
  mesh_part<3>(F) = T;
  return F;
}
inline Gradient<3> turned(const Tensor<3>& R, const Gradient<3>& F) {
  return gradient_of(R * mesh_part<3>(F));
}

/// Q F Q' and Q t Q' of what belongs to the plane x, y.
inline Gradient<3> in_space(const Gradient<2>& F, const Tensor<3>& Q) {
  Tensor<3> T = Tensor<3>::Zero();
  T.topLeftCorner<2, 2>() = mesh_part<2>(F);
  T(2, 2) = F[ZZ];
  return gradient_of(Q * T * Q.transpose());
}
inline Stress<3> in_space(const Stress<2>& t, const Tensor<3>& Q) {
  Stress<3> flat;
  flat << t[0], t[1], t[2], t[3], 0, 0;
  return rotated(flat, Q);
}

/// A gradient that changes all components.
inline Gradient<3> gradient_in_space(double size) {
  return undeformed<3>() +
         size * (Gradient<3>() << 0.6, 0.2, -0.3, 0.5, -0.4, 0.35, -0.25, 0.45, 0.15).finished();
}

} // namespace burnish::test
