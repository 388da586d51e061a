#pragma once
// Plane polygons.
#include "base/types.hpp"
#include <array>
#include <vector>

namespace burnish {

/// Triangles that fill a polygon, counter-clockwise, each three numbers of its corners: ears are cut off one after the other
///. Corners that coincide or lie on a line with their neighbors give none.
/// @param corners in either order, of a polygon that does not cross itself
std::vector<std::array<int, 3>> polygon_triangles(const std::vector<Vector<2>>& corners);

} // namespace burnish
