#pragma once
// How near points of space are to a tool where it is, for loops that a script writes itself.
#include "kinematics/tool.hpp"

namespace burnish {

/// The tool's closest point to a point of space, in space (METHOD.md 2.2). Along a motion of the point the gap changes by
/// n dx, and n by E H E' dx with H = (1 + gap B)^-1 B; both hold away from the ends of an open tool.
template <int Dim> struct ToolFoot {
  Vector<Dim> x, n;    ///< foot; unit normal out of the tool
  Tangents<Dim> E;     ///< orthonormal tangents; in the plane the direction of travel
  Curvature<Dim> B;    ///< curvature in them, positive where the tool is convex [1/length]
  double gap;          ///< along n, positive outside the tool [length]
  bool on_end = false; ///< the foot is an end of an open tool: gap is the distance to it, n the normal there
};

/// Feet of all points, in their order.
/// @param q  generalized coordinates of the tool [length or rad]
/// @throws std::invalid_argument if a point is not finite or q is refused by the tool
template <int Dim>
std::vector<ToolFoot<Dim>> tool_feet(const Tool<Dim>& tool, const Eigen::VectorXd& q,
                                     const std::vector<Vector<Dim>>& points);

} // namespace burnish
