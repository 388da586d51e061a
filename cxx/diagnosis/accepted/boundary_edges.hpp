#pragma once
// The boundary of a mesh as straight pieces between neighboring nodes, whatever labels it bears.
#include "base/archive.hpp"
#include "contact/body_view.hpp"
#include "mesh/mesh.hpp"

namespace burnish {

/// From a node to the next one along an element's edge, mid nodes included.
template <int Dim> struct BoundaryEdge;
template <> struct BoundaryEdge<2> {
  int a = -1, b = -1; ///< the body is on the left
  BURNISH_FIELDS(a, b)
};
template <> struct BoundaryEdge<3> {
  int a = -1, b = -1;
  std::array<std::array<int, 3>, 2>
      faces{}; ///< vertices of both boundary faces there, seen from outside counter-clockwise
  BURNISH_FIELDS(a, b, faces)
};

/// All of them: edges of faces that belong to one element.
std::vector<BoundaryEdge<2>> boundary_edges(const Mesh<2>& mesh);
std::vector<BoundaryEdge<3>> boundary_edges(const Mesh<3>& mesh);

/// A direction out of the body at an edge; in space the sum of both faces' unit normals.
Vector<2> outward(const BodyView<2>& body, const Eigen::VectorXd& u, const BoundaryEdge<2>& edge);
Vector<3> outward(const BodyView<3>& body, const Eigen::VectorXd& u, const BoundaryEdge<3>& edge);

} // namespace burnish
