#pragma once
// Cartesian coordinates of a tool in space: position of its frame and a rotation vector.
#include "kinematics/coordinates.hpp"
#include <Eigen/Geometry>

namespace burnish {

/// q = (x, y, z, spinx, spiny, spinz): origin = (x, y, z) [length]; the spins are a rotation vector [rad] from a reference
/// that turns along, METHOD.md (2.16): with v what they have changed by since, R = the rotation by |v| about v, after the
/// reference's. A run renews the reference at the end of every step; before, it is the frame of space and v the spins
/// themselves. So there is no singular pose (a step never turns by 2 pi), and each spin is the integral of the angular
/// velocity about an axis fixed in space: turns about one axis alone add up as an angle, turns about several do not
/// commute, and the same spins reached on another way are another rotation. Conjugate forces on the tool: Q_x, Q_y, Q_z
/// [force]; Q_spin [force length] from the moment M about the frame's origin, METHOD.md (2.14):
///   v = 0               Q_spinx, Q_spiny, Q_spinz are the components of M
///   one of them alone   its Q is M about its axis; those of the others are M about axes that have turned by half of
///                       the angle and have the length sin(|v|/2)/(|v|/2)
///   always              v . Q_spin = v . M
/// (Moments about axes fixed in space are not conservative where two of them act at once.) The carrier is the default one,
/// the translation of the origin.
class CartesianInSpace : public Coordinates<3> {
public:
  /// "x", "y", "z", "spinx", "spiny", "spinz".
  const std::vector<std::string>& names() const override;
  /// Pose at q, 6. @throws std::invalid_argument if q is not 6 finite numbers
  Pose<3> pose(const Eigen::VectorXd& q) const override;
  /// Spins, and the rotation there as a unit quaternion (w, x, y, z): 7.
  Eigen::VectorXd reference() const override;
  Eigen::VectorXd reference_at(const Eigen::VectorXd& q) const override;
  /// @throws std::invalid_argument for one that is not of this kind
  void refer_to(const Eigen::VectorXd& reference) const override;

private:
  mutable Vector<3> m_spin = Vector<3>::Zero();
  mutable Eigen::Quaterniond m_turned = Eigen::Quaterniond::Identity();
};

} // namespace burnish
