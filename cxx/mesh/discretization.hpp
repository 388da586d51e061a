#pragma once
// The finite-element space of the workpiece as plain arrays: reference nodes, elements, quadrature.
#include "base/types.hpp"
#include <vector>

namespace burnish {

/// Everything refers to the reference configuration; integration happens there (method.md section 1).
/// Axisymmetric (Dim 2): x = r >= 0, y along the axis, displacements and forces without torsion; weights hold
/// 2 pi R, so that nodal forces are those of the whole ring [force], not per unit of thickness or angle.
template <int Dim> struct Discretization {
  int num_nodes = 0, nodes_per_element = 0, points_per_element = 0, num_elements = 0;
  bool axisymmetric = false;      ///< x is the radius; weights and nodal forces are those of whole rings
  std::vector<double> X;          ///< reference node coordinates, num_nodes x Dim [length]
  std::vector<int> connectivity;  ///< num_elements x nodes_per_element; the Dim+1 vertices come first
  std::vector<double> weight;     ///< num_points: quadrature weight times element volume [length^Dim],
                                  ///< axisymmetric: times 2 pi R [length^3]
  std::vector<double> shape;      ///< num_points x nodes_per_element: N_a [-]
  std::vector<double> shape_grad; ///< num_points x nodes_per_element x Dim: dN_a/dX_j [1/length]
  std::vector<double> point;      ///< num_points x Dim: reference position of the quadrature points [length]

  int num_points() const { return num_elements * points_per_element; }
  int num_dofs() const { return Dim * num_nodes; }
  Vector<Dim> node(int a) const { return Eigen::Map<const Vector<Dim>>(X.data() + Dim * a); }
  const int* element(int e) const {
    return connectivity.data() + static_cast<std::size_t>(e) * nodes_per_element;
  }
  /// N_a at point p (global point number), nodes_per_element.
  const double* shapes(int p) const { return shape.data() + static_cast<std::size_t>(p) * nodes_per_element; }
  /// 1/R at point p where axisymmetric: N_a/R is the hoop gradient of node a, on its radial dof [1/length].
  double inverse_radius(int p) const { return 1 / point[static_cast<std::size_t>(Dim) * p]; }
  /// dN_a/dX at point p, nodes_per_element x Dim, row-major.
  const double* gradients(int p) const {
    return shape_grad.data() + static_cast<std::size_t>(p) * nodes_per_element * Dim;
  }
};

/// Straight triangles, vertices counter-clockwise: P1 (3 nodes, 1 point, the centroid) or P2 (6 nodes,
/// vertices then the mid-edge nodes opposite vertex 0, 1, 2; 3 points). Point q of P2 is the middle of the
/// edge opposite vertex q, as FreeFEM's FEQF2; axisymmetric, where N/R is 0/0 on the axis, the inner point
/// nearest to vertex q (barycentric coordinate 2/3 there, 1/6 at the others). The quadrature is exact for
/// polynomials of degree 1 (P1), 2 (P2), the factor 2 pi R included.
/// @param X            node coordinates, num_nodes x 2 [length]
/// @param connectivity num_elements x (3 or 6)
/// @throws std::invalid_argument for a bad size, an index out of range, a non-finite coordinate, an inverted
///         element (names its number and area), a P2 mid-edge node that is not in the middle of its edge
///         (names element and node), or, axisymmetric, a node at x < 0 by more than rounding (names it)
Discretization<2> triangles(int nodes_per_element, std::vector<double> X, std::vector<int> connectivity,
                            bool axisymmetric = false);

} // namespace burnish
