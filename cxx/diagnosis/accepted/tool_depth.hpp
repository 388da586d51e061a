#pragma once
// How deep a tool reaches into a straight edge of the workpiece (ALGORITHMS.md 16.3).
#include "kinematics/tool.hpp"

namespace burnish {

/// Where a tool and an edge are closest.
struct ToolDepth {
  double depth = 0; ///< of the tool's surface beyond the edge; negative: they are apart [length]
  Vector<2> x = Vector<2>::Zero(); ///< point of the edge [length]
  Vector<2> n = Vector<2>::Zero(); ///< normal of the tool there
  bool on_end = false;             ///< the foot is an end of an open tool
};

/// Closest approach along the straight edge from a to b [length], by bisection of the slope of the gap: exact but for 1e-3
/// of the edge where the tool is convex there. @param hint of a place nearby
ToolDepth tool_depth(const Tool<2>& tool, const Pose<2>& pose, const Vector<2>& a, const Vector<2>& b,
                     const Param<2>& hint);

} // namespace burnish
