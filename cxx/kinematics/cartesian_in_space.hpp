#pragma once
// Cartesian coordinates of a tool in space: position of its frame and a rotation vector.
#include "kinematics/coordinates.hpp"

namespace burnish {

/// q = (x, y, z, spinx, spiny, spinz): origin = (x, y, z) [length], R = the rotation by |spin| [rad] about the
/// direction of spin, METHOD.md (2.12). A function of q as any other: nothing is accumulated, and there is no order
/// of turns. Conjugate forces on the tool: Q_x, Q_y, Q_z [force]; Q_spin [force length] from the moment M about the
/// frame's origin, METHOD.md (2.14):
///   spin = 0            Q_spinx, Q_spiny, Q_spinz are the components of M
///   one of them alone   its Q is M about its axis; those of the others are M about axes that have turned by half of
///                       the angle and have the length sin(|spin|/2)/(|spin|/2)
///   always              spin . Q_spin = spin . M
/// (Moments about axes fixed in space are conjugate to no coordinates: two of them at once are not conservative.)
/// At |spin| = 2 pi turns about other axes than that of spin move nothing: singular under force control. A tool that
/// is free to roll further takes an angle about its own axis instead, FormulaCoordinates or PolarInSpace.
/// The carrier is the default one, the translation of the origin.
class CartesianInSpace : public Coordinates<3> {
public:
  /// "x", "y", "z", "spinx", "spiny", "spinz".
  const std::vector<std::string>& names() const override;
  /// Pose at q, 6. @throws std::invalid_argument if q is not 6 finite numbers
  Pose<3> pose(const Eigen::VectorXd& q) const override;
};

} // namespace burnish
