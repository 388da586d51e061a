#pragma once
// A new mesh of a deformed workpiece of tetrahedra, made by gmsh (ALGORITHMS.md 19.2).
#include "mesh/mesh.hpp"

namespace burnish {

/// Linear tetrahedra and the faces of their surface.
struct VolumeMesh {
  std::vector<Vector<3>> node; ///< [length]
  std::vector<std::array<int, 4>> tetrahedron;
  std::vector<std::array<int, 3>> face; ///< counter-clockwise seen from outside
  std::vector<long> label;              ///< of each face
};

/// Lengths of edges at the corners of every element, 4 x num_elements [length].
using CornerSizes = Eigen::Matrix<double, 4, Eigen::Dynamic>;
/// The deformed body meshed anew: labels and sharp edges stay, vertices of the surface are on the quadratic one.
/// @param u displacement, num_dofs [length]
/// @throws std::invalid_argument unless all sizes are > 0 and finite, if they make more than five million tetrahedra, and with
///         what gmsh says where it fails
VolumeMesh volume_mesh(const Mesh<3>& mesh, const Eigen::VectorXd& u, const CornerSizes& sizes);
/// The same with elements as large as those of the reference mesh there, so that their number is as good as the same, more where
/// the body is stretched.
VolumeMesh volume_mesh(const Mesh<3>& mesh, const Eigen::VectorXd& u);

} // namespace burnish
