#pragma once
// Coordinates of a tool by formula: any number of names, and where the tool's frame is as text.
#include "formula/formula.hpp"
#include "kinematics/coordinates.hpp"
#include "kinematics/rotation_formula.hpp"
#include <array>

namespace burnish {

/// Position of the frame's origin [length] and absolute rotation of the frame as formulas of the coordinates and of
/// the parameters.
template <int Dim> struct PoseFormulas;
template <> struct PoseFormulas<2> {
  std::string x, y, angle = "0"; ///< [rad, counter-clockwise]
};
template <> struct PoseFormulas<3> {
  std::string x, y, z, rotation = {}; ///< as rotation_formulas reads it
};
using PlaneFormulas = PoseFormulas<2>;
using SpaceFormulas = PoseFormulas<3>;

/// origin = (x, y) or (x, y, z), R = the rotation. Conjugate force of coordinate k on the tool: what does work
/// along a change of that coordinate alone, Q_k = origin_k . f + axis_k . M, with the force f put at the frame's
/// origin and the moment M about it; in the plane axis_k is the derivative of the angle, in space METHOD.md (2.14).
/// One coordinate may drive several of them: crank, screw. Four formulas of a quaternion are one too many: one
/// coordinate of four must be under motion then. The carrier is the default one, the translation of the origin.
template <int Dim> class FormulaCoordinates : public Coordinates<Dim> {
public:
  /// @param tool        its name, for messages
  /// @param names       of the coordinates, one or more
  /// @param parameters  numbers that the formulas call by name
  /// @throws std::invalid_argument naming tool and formula for everything that Formula and rotation_formulas
  /// refuse; for names that are no identifiers, are taken or repeated, and for a coordinate on which no formula
  /// depends
  FormulaCoordinates(const std::string& tool, std::vector<std::string> names,
                     const PoseFormulas<Dim>& formulas, const std::map<std::string, double>& parameters = {});

  const std::vector<std::string>& names() const override { return m_names; }
  /// Pose at q with exact derivatives, METHOD.md (2.15).
  /// @throws std::invalid_argument if q is not one finite number per name, and, quoting tool, formula and q,
  /// where a formula or one of its derivatives has no finite real value
  Pose<Dim> pose(const Eigen::VectorXd& q) const override;

private:
  struct Component {
    std::string label;
    Formula value;
    std::vector<Formula> first;               ///< [k]
    std::vector<std::vector<Formula>> second; ///< [k][l <= k]
  };
  void add(std::vector<Component>& components, const std::string& tool, const FormulaText& formula,
           const std::map<std::string, double>& parameters) const;
  void require_use(const std::string& tool) const;
  void set_origin(Pose<Dim>& pose, const double* q) const;
  void set_rotation(Pose<Dim>& pose, const double* q) const;

  std::vector<std::string> m_names;
  std::vector<Component> m_origin, m_numbers; ///< of the origin; of the rotation
  std::shared_ptr<const Rotation<Dim>> m_rotation;
};

/// Names of a list such as "r, phi, theta". @throws std::invalid_argument for an empty list or item
std::vector<std::string> coordinate_names(const std::string& list);

} // namespace burnish
