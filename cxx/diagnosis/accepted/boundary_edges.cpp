#include "diagnosis/accepted/boundary_edges.hpp"
#include "mesh/simplex.hpp"
#include <algorithm>
#include <map>

namespace burnish {

namespace {

using Ends = std::pair<int, int>;
using Face = std::array<int, 3>;

// Faces of one element, seen from outside counter-clockwise.
std::vector<Face> boundary_faces(const Mesh<3>& mesh) {
  constexpr int face_of[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}; // opposite the vertices 0 to 3
  std::map<Face, std::pair<int, Face>> faces;                                 // by sorted vertices: how often
  for (int e = 0; e < mesh.num_elements; ++e)
    for (const auto& of : face_of) {
      const int* node = mesh.element(e);
      const Face face{node[of[0]], node[of[1]], node[of[2]]};
      Face sorted = face;
      std::sort(sorted.begin(), sorted.end());
      auto& entry = faces[sorted];
      ++entry.first;
      entry.second = face;
    }
  std::vector<Face> list;
  for (const auto& [sorted, entry] : faces)
    if (entry.first == 1) list.push_back(entry.second);
  return list;
}

std::map<Ends, int> mid_nodes(const Mesh<3>& mesh) {
  std::map<Ends, int> middle;
  for (int e = 0; mesh.nodes_per_element == 10 && e < mesh.num_elements; ++e)
    for (std::size_t k = 0; k < SimplexEdges<3>::ends.size(); ++k) {
      const int* node = mesh.element(e);
      middle[std::minmax(node[SimplexEdges<3>::ends[k][0]], node[SimplexEdges<3>::ends[k][1]])] = node[4 + k];
    }
  return middle;
}

} // namespace

std::vector<BoundaryEdge<2>> boundary_edges(const Mesh<2>& mesh) {
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
  std::vector<BoundaryEdge<2>> edges;
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

std::vector<BoundaryEdge<3>> boundary_edges(const Mesh<3>& mesh) {
  std::map<Ends, BoundaryEdge<3>> edges;
  for (const auto& face : boundary_faces(mesh))
    for (int k = 0; k < 3; ++k) {
      const int a = face[k], b = face[(k + 1) % 3];
      BoundaryEdge<3>& edge = edges[std::minmax(a, b)];
      edge.faces[edge.a < 0 ? 0 : 1] = face;
      edge.a = a;
      edge.b = b;
    }
  const std::map<Ends, int> middle = mid_nodes(mesh);
  std::vector<BoundaryEdge<3>> list;
  for (const auto& [ends, edge] : edges) {
    const auto found = middle.find(ends);
    if (found == middle.end()) {
      list.push_back(edge);
      continue;
    }
    list.push_back({edge.a, found->second, edge.faces});
    list.push_back({found->second, edge.b, edge.faces});
  }
  return list;
}

Vector<2> outward(const BodyView<2>& body, const Eigen::VectorXd& u, const BoundaryEdge<2>& edge) {
  const Vector<2> along = body.position(u, edge.b) - body.position(u, edge.a);
  return {along[1], -along[0]};
}

Vector<3> outward(const BodyView<3>& body, const Eigen::VectorXd& u, const BoundaryEdge<3>& edge) {
  Vector<3> sum = Vector<3>::Zero();
  for (const auto& face : edge.faces) {
    const Vector<3> a = body.position(u, face[0]);
    sum += (body.position(u, face[1]) - a).cross(body.position(u, face[2]) - a).normalized();
  }
  return sum;
}

} // namespace burnish
