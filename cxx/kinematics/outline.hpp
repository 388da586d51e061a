#pragma once
// The outline of a plane tool where it is, for pictures.
#include "kinematics/tool.hpp"

namespace burnish {

/// Points of the tool's surface in space: n uniform in the profile's parameter from its begin to its end (a
/// closed profile ends where it began), and the joints of its pieces between them, in the order of travel.
/// @param q  generalized coordinates of the tool [length or rad]
/// @param n  at least 2
/// @return n points or more, each 2 [length]
/// @throws std::invalid_argument if n < 2 or q is refused by the tool
std::vector<Vector<2>> outline(const Tool<2>& tool, const Eigen::VectorXd& q, long n);

} // namespace burnish
