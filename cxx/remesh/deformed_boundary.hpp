#pragma once
// The boundary of a deformed plane workpiece: its arcs, divided anew for a mesh generator, and where mid nodes of a new mesh
// belong (ALGORITHMS.md 19.2).
#include "mesh/mesh.hpp"

namespace burnish {

/// An edge of the boundary where it is now: the parabola through its nodes, a straight one where the edge is linear.
struct BoundaryArc {
  std::array<Vector<2>, 3> x; ///< start, middle, end; the body is on the left [length]
  std::array<int, 2> vertex;  ///< start and end
  long label = 0;
  double reference = 0;         ///< its length in the reference configuration [length]
  Vector<2> at(double s) const; ///< 0 <= s <= 1
};
/// Edges of one element only, in loops: each ends where the next one begins.
/// @param u displacement, num_dofs [length]
std::vector<std::vector<BoundaryArc>> boundary_loops(const Mesh<2>& mesh, const Eigen::VectorXd& u);

struct OutlineEdge {
  Vector<2> from, to; ///< the body is on the left [length]
  long label = 0;
};
/// The boundary as straight edges between places on it. Corners and ends of labels stay; between them the edges are as long
/// as those of the reference mesh there, or as `size` says.
/// @param size length of an edge; 0: that of the reference mesh [length]
/// @throws std::invalid_argument if size is < 0 or not finite
std::vector<OutlineEdge> outline(const Mesh<2>& mesh, const Eigen::VectorXd& u, double size);

/// Displacement that takes the mid nodes of a new mesh's boundary to the deformed boundary of the old one, those of curved
/// edges a little further or less so that the volume is that of the old one; at components that are not fixed. Zero elsewhere,
/// where no arc of the same label is within a quarter of the edge, of linear elements, and in space.
/// @param fixed num_dofs flags of the new mesh; @returns num_dofs of it [length]
template <int Dim>
Eigen::VectorXd boundary_displacement(const Mesh<Dim>& old, const Eigen::VectorXd& u, const Mesh<Dim>& fresh,
                                      const std::vector<char>& fixed);

} // namespace burnish
