#pragma once
// The boundary of a deformed plane workpiece: its arcs, divided anew for a mesh generator, and where mid nodes of a new mesh
// belong (ALGORITHMS.md 19.2).
#include "mesh/mesh.hpp"
#include "remesh/parabola.hpp"

namespace burnish {

constexpr double SHARP_TURN = 0.3; ///< turn of the boundary from which a corner or an edge stays [rad]
constexpr double WITHIN = 0.25;    ///< of an edge: how far its mid node may be moved
constexpr double CURVED = 1e-4;    ///< of an edge: the bulge of a straight one is smaller

/// An edge of the boundary where it is now, straight where it is linear.
struct BoundaryArc {
  Parabola<2> x;             ///< the body is on the left
  std::array<int, 2> vertex; ///< start and end
  long label = 0;
  double reference = 0; ///< its length in the reference configuration [length]
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
/// where no arc of the same label is within a quarter of the edge, and of linear elements. In space: surface_displacement.
/// @param fixed num_dofs flags of the new mesh; @returns num_dofs of it [length]
template <int Dim>
Eigen::VectorXd boundary_displacement(const Mesh<Dim>& old, const Eigen::VectorXd& u, const Mesh<Dim>& fresh,
                                      const std::vector<char>& fixed);

} // namespace burnish
