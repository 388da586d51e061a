#pragma once
// Small meshes of tetrahedra.
#include "mesh/discretization.hpp"
#include "mesh/simplex.hpp"
#include <map>

namespace burnish::test {

/// Linear tetrahedra. @param X num_nodes x 3; @param connectivity num_elements x 4
inline Mesh<3> linear_tetrahedra(std::vector<double> X, std::vector<int> connectivity) {
  Mesh<3> mesh;
  mesh.num_nodes = static_cast<int>(X.size() / 3);
  mesh.nodes_per_element = 4;
  mesh.num_elements = static_cast<int>(connectivity.size() / 4);
  mesh.X = std::move(X);
  mesh.connectivity = std::move(connectivity);
  return mesh;
}

/// The same with nodes in the middle of all edges, after the vertices; without facets.
inline Mesh<3> quadratic_tetrahedra(const Mesh<3>& linear) {
  Mesh<3> mesh = linear_tetrahedra(linear.X, {});
  std::map<std::pair<int, int>, int> middle;
  for (int e = 0; e < linear.num_elements; ++e) {
    const int* corner = linear.element(e);
    mesh.connectivity.insert(mesh.connectivity.end(), corner, corner + 4);
    for (const auto& ends : SimplexEdges<3>::ends) {
      const int a = corner[ends[0]], b = corner[ends[1]];
      const auto [place, fresh] = middle.emplace(std::minmax(a, b), static_cast<int>(mesh.X.size() / 3));
      mesh.connectivity.push_back(place->second);
      for (int c = 0; fresh && c < 3; ++c) mesh.X.push_back((mesh.X[3 * a + c] + mesh.X[3 * b + c]) / 2);
    }
  }
  mesh.num_nodes = static_cast<int>(mesh.X.size() / 3);
  mesh.nodes_per_element = 10;
  mesh.num_elements = linear.num_elements;
  return mesh;
}

/// Two that share a face. @param nodes_per_element 4 or 10
inline Discretization<3> two_tetrahedra(int nodes_per_element) {
  const Mesh<3> linear = linear_tetrahedra({0, 0, 0, 1.1, 0, 0.1, 0.2, 0.9, 0, 0, 0.1, 1, 1, 1.1, 0.9},
                                           {0, 1, 2, 3, 1, 2, 3, 4});
  return tetrahedra(nodes_per_element == 4 ? linear : quadratic_tetrahedra(linear));
}

} // namespace burnish::test
