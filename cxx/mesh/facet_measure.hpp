#pragma once
// Integrals over boundary facets in their present place.
#include "mesh/mesh.hpp"
#include "mesh/simplex.hpp"

namespace burnish {

/// A point of a triangle: barycentric coordinates, weight; the weights sum up to 1/2, the area in the plane of l1 and l2.
struct TrianglePoint {
  Barycentric<2> l;
  double weight;
};
/// Seven points, exact to degree 5.
const std::array<TrianglePoint, 7>& triangle_rule();
/// Derivatives of the place by l1 and l2 on a triangle in space, where l0 = 1 - l1 - l2, as columns.
/// @param x its 3 or 6 nodes, in the order of nodes_of [length]
Eigen::Matrix<double, 3, 2> triangle_tangents(const std::vector<Vector<3>>& x, const Barycentric<2>& l);

template <int Dim> class FacetMeasure {
public:
  virtual ~FacetMeasure() = default;
  /// Integrals of N_i phi_j dA over a facet: N_i the shape functions of its nodes, phi_j the linear functions of its
  /// vertices. @param x present places of nodes_of(facet) [length]
  /// @return nodes x vertices [length in the plane, area in space and of whole rings]
  virtual Eigen::MatrixXd masses(const std::vector<Vector<Dim>>& x) const = 0;
};

/// Edges of the plane, of 2 or 3 nodes: dA = dl, or 2 pi r dl where axisymmetric (r = x). A bent quadratic edge counts as
/// long as the two chords to its mid node.
class EdgeMeasure final : public FacetMeasure<2> {
public:
  explicit EdgeMeasure(bool axisymmetric = false) : m_axisymmetric(axisymmetric) {}
  Eigen::MatrixXd masses(const std::vector<Vector<2>>& x) const override;

private:
  bool m_axisymmetric;
};

/// Triangles of space, of 3 or 6 nodes in the order of Facet (SimplexEdges<2>), curved ones as they are: dA is that of the
/// quadratic map. By triangle_rule: flat triangles whose mid nodes lie in the middle need 2 (T3) or 3 (T6).
/// Integral of the shape functions there: A/3 at every node of T3; 0 at the vertices and A/3 at the mid nodes of T6.
class FaceMeasure final : public FacetMeasure<3> {
public:
  Eigen::MatrixXd masses(const std::vector<Vector<3>>& x) const override;
};

} // namespace burnish
