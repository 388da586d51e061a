#include "diagnosis/accepted/boundary_edges.hpp"
#include "mesh/simplex.hpp"
#include <algorithm>
#include <map>

namespace burnish {

std::vector<BoundaryEdge> boundary_edges(const Mesh<2>& mesh) {
  std::map<std::pair<int, int>, int> sharing;
  const auto for_edges = [&](const auto& f) {
    for (int e = 0; e < mesh.num_elements; ++e)
      for (int k = 0; k < 3; ++k) {
        const int* node = mesh.element(e);
        const int a = node[SimplexEdges<2>::ends[k][0]], b = node[SimplexEdges<2>::ends[k][1]];
        f(a, b, mesh.nodes_per_element == 6 ? node[3 + k] : -1);
      }
  };
  for_edges([&](int a, int b, int) { ++sharing[std::minmax(a, b)]; });
  std::vector<BoundaryEdge> edges;
  for_edges([&](int a, int b, int middle) {
    if (sharing[std::minmax(a, b)] != 1) return;
    if (middle < 0) {
      edges.push_back({a, b});
      return;
    }
    edges.push_back({a, middle});
    edges.push_back({middle, b});
  });
  return edges;
}

} // namespace burnish
