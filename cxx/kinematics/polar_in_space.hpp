#pragma once
// Polar coordinates of a tool in space about a fixed line.
#include "geometry/axis_frame.hpp"
#include "kinematics/polar.hpp"

namespace burnish {

/// q = (r, phi, z, theta): plane polar coordinates about the axis, and z along it: with the axis' point c and
/// directions e1, e2, a: origin = c + r (cos phi e1 + sin phi e2) + z a; theta = ABSOLUTE rotation of the tool's
/// frame about a, which at theta = 0 is parallel to the axes of space. Conjugate forces on the tool:
///   Q_r      away from the axis [force]                        Q_z      along a [force]
///   Q_phi    moment about the axis of the force put at the frame's origin [force length]
///   Q_theta  moment about a through the frame's origin [force length]
/// At r = 0 the coordinate phi moves nothing (singular under force control).
class PolarInSpace : public Coordinates<3> {
public:
  explicit PolarInSpace(const AxisFrame& axis = {}) : m_axis(axis) {}
  const AxisFrame& axis() const { return m_axis; }

  /// "r", "phi", "z", "theta".
  const std::vector<std::string>& names() const override;
  /// Pose at q, 4. @throws std::invalid_argument if q is not 4 finite numbers
  Pose<3> pose(const Eigen::VectorXd& q) const override;
  /// Turn about the axis by phi_to - phi_from, and the way along it.
  RigidMotion<3> carrier(const Eigen::VectorXd& q_from, const Eigen::VectorXd& q_to) const override;

private:
  Vector<3> in_space(const Vector<2>& v) const { return m_axis.base.leftCols<2>() * v; }
  Tensor<3> in_space(const Tensor<2>& T) const {
    return m_axis.base.leftCols<2>() * T * m_axis.base.leftCols<2>().transpose();
  }

  AxisFrame m_axis;
  Polar m_plane; ///< of r, phi, theta
};

} // namespace burnish
