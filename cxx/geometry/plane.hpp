#pragma once
// Directions and rotations of the plane, shared by closed-form profiles and plane coordinates.
#include "base/types.hpp"
#include <cmath>

namespace burnish {

/// e(angle) = (cos, sin), the unit vector of METHOD.md 2.1; 2 [-]; angle [rad], counter-clockwise.
inline Vector<2> plane_direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// v turned by +90 degrees: e'(angle) = left_of(e(angle)); 2, unit of v.
inline Vector<2> left_of(const Vector<2>& v) { return {-v.y(), v.x()}; }

/// a_x b_y - a_y b_x: positive where b points to the left of a; product of their units.
inline double cross(const Vector<2>& a, const Vector<2>& b) { return left_of(a).dot(b); }

/// Rotation by angle [rad], counter-clockwise; 2 by 2, columns e and e'.
inline Tensor<2> plane_rotation(double angle) {
  const Vector<2> e = plane_direction(angle);
  Tensor<2> rotation;
  rotation << e, left_of(e);
  return rotation;
}

/// dR/d(angle) of a rotation R = plane_rotation(angle): the columns turned by +90 degrees; the second
/// derivative is -R. 2 by 2.
inline Tensor<2> plane_rotation_derivative(const Tensor<2>& R) {
  Tensor<2> derivative;
  derivative << left_of(R.col(0)), left_of(R.col(1));
  return derivative;
}

} // namespace burnish
