#pragma once
// How a tool moves with one of its coordinates.
#include "kinematics/coordinates.hpp"

namespace burnish {

/// Twist for a unit rate of coordinate k: velocity of the frame's origin, Dim numbers [length, or length/rad], then the
/// angular velocity of the frame, in the plane one number, in space three [rad/length, or 1]: the axial vector of
/// R_q R^T; the growth of METHOD.md 2.8 is no part of it. The force of the coordinate is what does work along it, METHOD.md (2.8).
template <int Dim> Eigen::VectorXd twist(const Pose<Dim>& pose, int k) {
  const auto coordinate = static_cast<std::size_t>(k);
  const Tensor<Dim> spin = pose.R_q[coordinate] * pose.R.transpose();
  Eigen::VectorXd result(3 * (Dim - 1));
  result.template head<Dim>() = pose.origin_q[coordinate];
  if constexpr (Dim == 2)
    result[2] = spin(1, 0);
  else
    result.template tail<3>() = Vector<3>(spin(2, 1), spin(0, 2), spin(1, 0));
  return result;
}

} // namespace burnish
