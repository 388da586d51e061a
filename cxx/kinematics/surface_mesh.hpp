#pragma once
// A tool's surface in space as triangles: what a picture shows and a file holds of it.
#include "geometry/surface_mesh.hpp"
#include "kinematics/tool.hpp"

namespace burnish {

/// Triangles in the tool's frame; a surface without ends, as a plane, is shown as far as the window reaches.
/// @param window in the tool's frame: its largest side sets how fine they are [length]
/// @throws std::invalid_argument for a window that is empty or not finite
SurfaceMesh surface_mesh(const Surface<3>& surface, const Eigen::AlignedBox3d& window);

/// The same in space, where the tool is.
/// @param q      generalized coordinates of the tool [length or rad]
/// @param window in space, for instance the box about the body
/// @throws std::invalid_argument as above, and if q is refused by the tool
SurfaceMesh surface_mesh(const Tool<3>& tool, const Eigen::VectorXd& q, const Eigen::AlignedBox3d& window);

} // namespace burnish
