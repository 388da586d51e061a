#pragma once
// Coordinates of a plane tool by formula: any number of names, and where the tool's frame is as text.
#include "formula/formula.hpp"
#include "kinematics/coordinates.hpp"

namespace burnish {

/// Position of the frame's origin [length] and absolute rotation of the frame [rad, counter-clockwise] as
/// formulas of the coordinates and of the parameters.
struct PlaneFormulas {
  std::string x, y, angle = "0";
};

/// origin = (x, y), R = rotation by angle. Conjugate force of coordinate k on the tool: what does work along
/// a change of that coordinate alone, Q_k = x_k f_x + y_k f_y + angle_k M, with the force f put at the
/// frame's origin and the moment M about it. One coordinate may drive several of the three: crank, screw.
/// The carrier is the default one, the translation of the origin.
class FormulaCoordinates : public Coordinates<2> {
public:
  /// @param tool        its name, for messages
  /// @param names       of the coordinates, one or more
  /// @param parameters  numbers that the formulas call by name
  /// @throws std::invalid_argument naming tool and formula for everything that Formula refuses; for names
  /// that are no identifiers, are taken or repeated, and for a coordinate on which no formula depends
  FormulaCoordinates(const std::string& tool, std::vector<std::string> names, const PlaneFormulas& formulas,
                     const std::map<std::string, double>& parameters = {});

  const std::vector<std::string>& names() const override { return m_names; }
  /// Pose at q with exact derivatives: R_k = R' angle_k, R_kl = R' angle_kl - R angle_k angle_l.
  /// @throws std::invalid_argument if q is not one finite number per name, and, quoting tool, formula and q,
  /// where a formula or one of its derivatives has no finite real value
  Pose<2> pose(const Eigen::VectorXd& q) const override;

private:
  struct Component {
    Formula value;
    std::vector<Formula> first;               ///< [k]
    std::vector<std::vector<Formula>> second; ///< [k][l <= k]
  };
  static Component component(const Formula& value, int size);
  void require_use(const std::string& tool) const;

  std::vector<std::string> m_names;
  Component m_x, m_y, m_angle;
};

/// Names of a list such as "r, phi, theta". @throws std::invalid_argument for an empty list or item
std::vector<std::string> coordinate_names(const std::string& list);

} // namespace burnish
