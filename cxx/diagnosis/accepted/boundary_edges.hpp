#pragma once
// The boundary of a mesh of the plane as straight pieces between neighboring nodes, whatever labels it bears.
#include "mesh/mesh.hpp"

namespace burnish {

/// From a node to the next one, mid nodes included; the body is on the left.
struct BoundaryEdge {
  int a = -1, b = -1;
};

/// All of them: edges that belong to one element.
std::vector<BoundaryEdge> boundary_edges(const Mesh<2>& mesh);

} // namespace burnish
