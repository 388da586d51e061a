#pragma once
// Lines on the surface of a deformed workpiece where its patches meet (ALGORITHMS.md 19.2).
#include "remesh/deformed_surface.hpp"

namespace burnish {

/// A line between two patches, from corner to corner; a closed one begins and ends at the same node.
struct PatchLine {
  std::array<int, 2> patches;
  std::vector<int> nodes; ///< in order, mid nodes too
};
/// All of them. A corner is where other patches meet, or the line turns sharply.
std::vector<PatchLine> patch_lines(const DeformedSurface& surface);

} // namespace burnish
