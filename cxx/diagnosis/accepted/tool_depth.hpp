#pragma once
// How deep a tool reaches into a straight edge of the workpiece (ALGORITHMS.md 16.3).
#include "kinematics/tool.hpp"

namespace burnish {

/// Where a tool and an edge are closest.
template <int Dim> struct ToolDepth {
  double depth = 0; ///< of the tool's surface beyond the edge; negative: they are apart [length]
  Vector<Dim> x = Vector<Dim>::Zero(); ///< point of the edge [length]
  Vector<Dim> n = Vector<Dim>::Zero(); ///< normal of the tool there
  bool on_end = false;                 ///< the foot is an end of an open tool
};

/// Closest approach along the straight edge from a to b [length], by bisection of the slope of the gap: exact but for 1e-3
/// of the edge where the tool is convex there. @param hint of a place nearby
template <int Dim>
ToolDepth<Dim> tool_depth(const Tool<Dim>& tool, const Pose<Dim>& pose, const Vector<Dim>& a,
                          const Vector<Dim>& b, const Param<Dim>& hint);

} // namespace burnish
