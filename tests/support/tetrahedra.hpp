#pragma once
// Two tetrahedra that share a face, with their quadrature, made by hand: the core has no maker of such meshes yet.
#include "mesh/discretization.hpp"
#include "mesh/simplex.hpp"
#include <map>

namespace burnish::test {

namespace detail {

/// Gradients of the barycentric coordinates and the volume.
struct Tetrahedron {
  std::array<Vector<3>, 4> vertex, gradient;
  double volume;
};
inline Tetrahedron tetrahedron(const Mesh<3>& mesh, int element) {
  Tetrahedron t;
  for (int v = 0; v < 4; ++v) t.vertex[v] = mesh.node(mesh.element(element)[v]);
  Tensor<3> edges;
  for (int v = 1; v < 4; ++v) edges.col(v - 1) = t.vertex[v] - t.vertex[0];
  t.volume = edges.determinant() / 6;
  const Tensor<3> rows = edges.inverse(); // row v - 1: gradient of l_v
  t.gradient[0].setZero();
  for (int v = 1; v < 4; ++v) {
    t.gradient[v] = rows.row(v - 1).transpose();
    t.gradient[0] -= t.gradient[v];
  }
  return t;
}

inline void add_point(Discretization<3>& mesh, const Tetrahedron& t, const Barycentric<3>& l) {
  Vector<3> x = Vector<3>::Zero();
  for (int v = 0; v < 4; ++v) x += l[v] * t.vertex[v];
  mesh.point.insert(mesh.point.end(), x.begin(), x.end());
  mesh.weight.push_back(t.volume / mesh.points_per_element);
  double shape[10];
  shape_functions<3>(mesh.nodes_per_element, l, shape);
  for (int a = 0; a < mesh.nodes_per_element; ++a) {
    if (mesh.shape.size() < static_cast<std::size_t>(mesh.points_per_element) * mesh.nodes_per_element)
      mesh.shape.push_back(shape[a]); // the same in all elements
    const Vector<3> gradient = shape_gradient<3, 3>(mesh.nodes_per_element, l, t.gradient, a);
    mesh.shape_grad.insert(mesh.shape_grad.end(), gradient.begin(), gradient.end());
  }
}

} // namespace detail

/// @param nodes_per_element 4: one point each; 10: four points each
inline Discretization<3> two_tetrahedra(int nodes_per_element) {
  Discretization<3> mesh;
  mesh.X = {0, 0, 0, 1.1, 0, 0.1, 0.2, 0.9, 0, 0, 0.1, 1, 1, 1.1, 0.9};
  const int corners[2][4] = {{0, 1, 2, 3}, {1, 2, 3, 4}};
  std::map<std::pair<int, int>, int> middle;
  for (const auto& corner : corners) {
    mesh.connectivity.insert(mesh.connectivity.end(), corner, corner + 4);
    for (int e = 0; nodes_per_element == 10 && e < 6; ++e) {
      const int a = corner[SimplexEdges<3>::ends[e][0]], b = corner[SimplexEdges<3>::ends[e][1]];
      const auto [place, fresh] = middle.emplace(std::minmax(a, b), static_cast<int>(mesh.X.size() / 3));
      mesh.connectivity.push_back(place->second);
      for (int c = 0; fresh && c < 3; ++c) mesh.X.push_back((mesh.X[3 * a + c] + mesh.X[3 * b + c]) / 2);
    }
  }
  mesh.num_nodes = static_cast<int>(mesh.X.size() / 3);
  mesh.nodes_per_element = nodes_per_element;
  mesh.num_elements = 2;
  mesh.points_per_element = nodes_per_element == 10 ? 4 : 1;
  for (int e = 0; e < mesh.num_elements; ++e)
    for (int q = 0; q < mesh.points_per_element; ++q) {
      Barycentric<3> l = Barycentric<3>::Constant(nodes_per_element == 10 ? 0.1381966011250105 : 0.25);
      l[q] = 1 - 3 * l[(q + 1) % 4];
      detail::add_point(mesh, detail::tetrahedron(mesh, e), l);
    }
  return mesh;
}

} // namespace burnish::test
