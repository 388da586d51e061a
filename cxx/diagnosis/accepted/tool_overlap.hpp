#pragma once
// How far two placed tools reach into each other (ALGORITHMS.md 16.3).
#include "kinematics/tool.hpp"

namespace burnish {

/// Of the plane.
struct PlacedTool {
  const Tool<2>* tool;
  const Pose<2>* pose;
  const std::vector<SurfacePlace<2>>* outline; ///< of the tool's surface, in the order of travel
  double spacing;                              ///< largest distance of neighboring places [length]
};

struct ToolOverlap {
  double depth =
      0; ///< smaller one of the largest depths of either outline in the other tool; 0: apart [length]
  double clear = 0;                ///< no point of one outline is nearer to the other one than that [length]
  Vector<2> x = Vector<2>::Zero(); ///< middle of the overlap [length]
};

/// Tools overlap if their outlines cross and each has points in the other one, or if both are closed and one is inside the
/// other one: what lies behind an open tool is not in it.
ToolOverlap tool_overlap(const PlacedTool& a, const PlacedTool& b);

} // namespace burnish
