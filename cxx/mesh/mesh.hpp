#pragma once
// The mesh of the workpiece as plain arrays: reference nodes, elements, boundary facets with their labels.
#include "base/types.hpp"
#include <array>
#include <string>
#include <vector>

namespace burnish {

/// One facet of the boundary: an edge in the plane, a triangle in space.
template <int Dim> struct Facet {
  std::array<int, Dim> vertex{}; ///< nodes; in the plane the body is on the left of vertex 0 -> 1
  std::array<int, Dim*(Dim - 1) / 2> middle{}; ///< mid nodes of its edges (SimplexEdges<Dim-1>); -1: linear
  int element = -1;                            ///< the element it bounds; -1: unknown
  long label = 0;
};

/// Simplices of equal order with straight edges, in the reference configuration.
/// Axisymmetric (Dim 2): x = r >= 0 is the radius, y runs along the axis.
template <int Dim> struct Mesh {
  int num_nodes = 0, nodes_per_element = 0, num_elements = 0;
  bool axisymmetric = false;
  std::vector<double> X;         ///< node coordinates, num_nodes x Dim [length]
  std::vector<int> connectivity; ///< num_elements x nodes_per_element; the Dim+1 vertices come first
  std::vector<Facet<Dim>> facets;

  int num_dofs() const { return Dim * num_nodes; }
  Vector<Dim> node(int a) const { return Eigen::Map<const Vector<Dim>>(X.data() + Dim * a); }
  const int* element(int e) const {
    return connectivity.data() + static_cast<std::size_t>(e) * nodes_per_element;
  }
};

/// Area or volume of the simplex of an element's vertices, negative if it is inverted [length^Dim].
template <int Dim> double signed_size(const Mesh<Dim>& mesh, int element);
template <> double signed_size(const Mesh<2>& mesh, int element);
template <> double signed_size(const Mesh<3>& mesh, int element);

/// @throws std::invalid_argument "where: ..." for a bad size, an index out of range, a coordinate that is not finite,
///         an inverted element (names its number, size and, in space, place; where nearly all are, that the mesh is
///         mirrored), or, axisymmetric, a node at x < 0 by more than rounding (names it)
template <int Dim> void require_valid(const Mesh<Dim>& mesh, const char* where);

/// Facets that bear one of the labels, in the order of the mesh.
/// @throws std::invalid_argument "where: ..." if there is none (lists the labels of the mesh)
template <int Dim>
std::vector<Facet<Dim>> facets_with(const Mesh<Dim>& mesh, const std::vector<long>& labels,
                                    const char* where);

/// Nodes of the facets, each once. In the plane neighbors follow one another along every chain of edges; in space
/// there is no such order: as the facets come.
template <int Dim> std::vector<int> nodes_along(const std::vector<Facet<Dim>>& facets);

/// Nodes of a facet: its vertices, then its mid nodes if it is quadratic.
template <int Dim> std::vector<int> nodes_of(const Facet<Dim>& facet) {
  std::vector<int> nodes(facet.vertex.begin(), facet.vertex.end());
  if (facet.middle[0] >= 0) nodes.insert(nodes.end(), facet.middle.begin(), facet.middle.end());
  return nodes;
}

/// The facet of an element opposite to its vertex f: in the plane the body is on its left, in space it is counter-clockwise seen from
/// outside. Without element and label.
/// @param nodes of the element: its vertices, then, if it is quadratic, the mid nodes of its edges (SimplexEdges<Dim>)
template <int Dim> Facet<Dim> facet_opposite(const int* nodes, bool quadratic, int f);

} // namespace burnish
