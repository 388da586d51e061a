#pragma once
// Integrals over boundary facets in their present place.
#include "mesh/mesh.hpp"

namespace burnish {

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

} // namespace burnish
