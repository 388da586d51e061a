#pragma once
// Triangles of a tool's surface in space, for pictures and files.
#include "base/types.hpp"
#include <Eigen/Geometry>
#include <array>
#include <vector>

namespace burnish {

struct SurfaceMesh {
  std::vector<Vector<3>> points;             ///< [length]
  std::vector<std::array<int, 3>> triangles; ///< points, counter-clockwise seen from the body
};

/// Largest distance of the triangles from the surface, of the largest side of the window (a circle about an axis has up to
/// 1440 corners).
inline constexpr double MESH_SAGITTA = 5e-4;

template <int Dim> class Surface;
template <int Dim> struct SurfacePlace;

/// Appends the triangles between neighboring rows of places, each row as long as the first; where a row shrinks to a point
/// (a pole) those without an area are left out. Orientation by the normals of the surface.
void add_rows(SurfaceMesh& mesh, const Surface<3>& surface,
              const std::vector<std::vector<SurfacePlace<3>>>& rows);

/// What only a surface of space has.
template <int Dim> class SurfaceInSpace {};
template <> class SurfaceInSpace<3> {
public:
  /// Triangles of the surface, no further from it than MESH_SAGITTA of the largest side of the window. What has no end
  /// is shown as far as the window reaches.
  /// @param window in the tool's frame, not empty [length]
  virtual SurfaceMesh mesh(const Eigen::AlignedBox3d& window) const = 0;

protected:
  ~SurfaceInSpace() = default;
};

} // namespace burnish
