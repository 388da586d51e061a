#pragma once
// What a script writes for the rotation of a tool in space.
#include "kinematics/rotation.hpp"
#include <map>
#include <memory>

namespace burnish {

/// A formula as text.
struct FormulaText {
  std::string label; ///< what it gives: "x", "rotation about z"
  std::string text;
};

/// A rotation and the formulas of its numbers.
template <int Dim> struct RotationFormulas {
  std::shared_ptr<const Rotation<Dim>> rotation;
  std::vector<FormulaText> numbers;
};

/// One of
///   "z:phi x:theta z:psi"     AXIS:ANGLE, any number of them, one after the other in the frame turned so far; an axis
///                             is x, y, z of that frame or [a b c], numbers or formulas of parameters; an angle is a
///                             formula [rad]
///   "vector: a, b, c"         rotation vector [rad]
///   "quaternion: w, a, b, c"  of any length > 0
///   ""                        none
/// @param where      "rotation of tool ..."
/// @param parameters numbers that axes may call by name
/// @throws std::invalid_argument "where "text": ..." for an axis that is none of these or has the length 0, a wrong
/// number of formulas, and a text without a colon
RotationFormulas<3> rotation_formulas(const std::string& where, const std::string& text,
                                      const std::map<std::string, double>& parameters);

} // namespace burnish
