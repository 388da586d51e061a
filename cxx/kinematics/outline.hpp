#pragma once
// The outline of a tool where it is, for pictures.
#include "kinematics/tool.hpp"

namespace burnish {

/// Points of the tool's surface in space: n spread evenly from its begin to its end (a closed curve ends where it
/// began), and the joints of its pieces between them, in the order of travel.
/// @param q  generalized coordinates of the tool [length or rad]
/// @param n  2 to 1 000 000
/// @return n points or more, each Dim [length]
/// @throws std::invalid_argument if n is out of range or q is refused by the tool
template <int Dim> std::vector<Vector<Dim>> outline(const Tool<Dim>& tool, const Eigen::VectorXd& q, long n);

} // namespace burnish
