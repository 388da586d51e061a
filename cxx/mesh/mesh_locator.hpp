#pragma once
// Which element holds a reference position.
#include "mesh/mesh.hpp"
#include "mesh/simplex.hpp"

namespace burnish {

/// Finds the element of a reference position by walking from a neighbor.
template <int Dim> class MeshLocator {
public:
  /// @param mesh must outlive the locator
  explicit MeshLocator(const Mesh<Dim>& mesh);
  /// A field may be continued out of the mesh by a fifth of an element.
  static constexpr double SLACK = 0.2;
  /// Element that contains P, or the boundary element reached when P lies outside by at most `slack` in
  /// barycentric coordinates; -1 otherwise. Walks from an element at mesh node `near`.
  int find(const Vector<Dim>& P, int near, double slack = SLACK) const;
  /// Values of the shape functions of an element at P (its nodes_per_element entries).
  void shape(int element, const Vector<Dim>& P, double* N) const;

private:
  Barycentric<Dim> barycentric(int element, const Vector<Dim>& P) const;
  const Mesh<Dim>* m_mesh;
  std::vector<int> m_neighbor; // per element and vertex: element across the opposite face, -1 at the boundary
  std::vector<int> m_any_element; // per node
};

} // namespace burnish
