#pragma once
// The finite-element space of the workpiece as plain arrays: reference nodes, elements, quadrature.
#include "mesh/mesh.hpp"

namespace burnish {

/// A mesh with its quadrature. Everything refers to the reference configuration; integration happens there
/// (METHOD.md 1.1, 1.3). Axisymmetric: displacements and forces without torsion; weights contain 2 pi R, so that nodal
/// forces are those of the whole ring [force], not per unit of thickness or angle.
template <int Dim> struct Discretization : Mesh<Dim> {
  int points_per_element = 0;
  std::vector<double> weight; ///< num_points: quadrature weight times element volume [length^Dim],
                              ///< axisymmetric: times 2 pi R [length^3]
  std::vector<double> shape;  ///< points_per_element x nodes_per_element: N_a, the same in all elements [-]
  std::vector<double> shape_grad; ///< num_points x nodes_per_element x Dim: dN_a/dX_j [1/length]
  std::vector<double> point;      ///< num_points x Dim: reference position of the quadrature points [length]

  int num_points() const { return this->num_elements * points_per_element; }
  /// N_a at point p (global point number), nodes_per_element.
  const double* shapes(int p) const {
    return shape.data() + static_cast<std::size_t>(p % points_per_element) * this->nodes_per_element;
  }
  /// 1/R at point p where axisymmetric: N_a/R is the hoop gradient of node a, on its radial dof [1/length].
  double inverse_radius(int p) const { return 1 / point[static_cast<std::size_t>(Dim) * p]; }
  /// dN_a/dX at point p, nodes_per_element x Dim, row-major.
  const double* gradients(int p) const {
    return shape_grad.data() + static_cast<std::size_t>(p) * this->nodes_per_element * Dim;
  }
};

/// Straight triangles, vertices counter-clockwise: P1 (3 nodes, 1 point, the centroid) or P2 (6 nodes,
/// vertices then the mid-edge nodes opposite vertex 0, 1, 2; 3 points). Point q of P2 is the middle of the
/// edge opposite vertex q, as FreeFEM's FEQF2; axisymmetric, where N/R is 0/0 on the axis, the inner point
/// nearest to vertex q (barycentric coordinate 2/3 there, 1/6 at the others). The quadrature is exact for
/// polynomials of degree 1 (P1), 2 (P2), the factor 2 pi R included.
/// @throws std::invalid_argument for what require_valid refuses, an inverted element (names its number and area),
///         and a P2 mid-edge node that is not in the middle of its edge (names element and node)
Discretization<2> triangles(Mesh<2> mesh);
/// The same from bare arrays, without facets.
/// @param X            node coordinates, num_nodes x 2 [length]
/// @param connectivity num_elements x (3 or 6)
Discretization<2> triangles(int nodes_per_element, std::vector<double> X, std::vector<int> connectivity,
                            bool axisymmetric = false);

/// Straight tetrahedra, seen from vertex 3 the others counter-clockwise: P1 (4 nodes, 1 point, the centroid) or P2 (10
/// nodes, vertices then mid-edge nodes in the order of SimplexEdges<3>; 4 points in the order of FreeFEM's FEQF23d:
/// nearest to vertex 1, 2, 3, 0). The quadrature is exact for polynomials of degree 1 (P1), 2 (P2).
/// @throws std::invalid_argument for what require_valid refuses, an axisymmetric mesh, an inverted element (names its
///         number, place and volume), and a P2 mid-edge node off the middle of its edge (names element and node)
Discretization<3> tetrahedra(Mesh<3> mesh);

/// @throws std::invalid_argument "where: ..." for arrays whose sizes are not those of the numbers, and for an axisymmetric mesh in space
template <int Dim> void require_sizes(const Discretization<Dim>& mesh, const char* where);

} // namespace burnish
