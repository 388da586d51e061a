#include "remesh/deformed_boundary.hpp"
#include "remesh/deformed_surface.hpp"
#include <cmath>
#include <map>

namespace burnish {
namespace {

constexpr double LEAST_DET = 0.5; // of a curved element anywhere at a vertex, over that of the straight one
constexpr int PASSES = 3;         // volume kept, then elements
constexpr int HALVES = 8;         // of the bulge of an edge, before it is straight

/// A node of the new surface.
struct SurfaceNode {
  std::set<int> patches;                // of the old surface that it belongs to
  double size = 0;                      // of the shortest edge at it [length]
  Vector<3> normal = Vector<3>::Zero(); // by area, outward [area]
};

std::map<int, SurfaceNode> surface_nodes(const DeformedSurface& old, const std::vector<BoundaryFace>& fresh) {
  std::map<int, SurfaceNode> nodes;
  for (const BoundaryFace& face : fresh) {
    const Vector<3> a = face.x[1] - face.x[0], b = face.x[2] - face.x[0];
    const int patch = old.nearest_patch(face.x[0] + (a + b) / 3, face.facet.label);
    const double size = std::min({a.norm(), b.norm(), (b - a).norm()});
    for (const int node : nodes_of(face.facet)) {
      SurfaceNode& at = nodes[node];
      if (patch >= 0) at.patches.insert(patch);
      at.size = at.size > 0 ? std::min(at.size, size) : size;
      at.normal += 0.5 * a.cross(b);
    }
  }
  return nodes;
}

// Mid nodes of edges whose ends have moved stay in the middle.
void follow_vertices(const Mesh<3>& mesh, Eigen::VectorXd& start) {
  for (int e = 0; e < mesh.num_elements; ++e)
    for (int i = 0; i < num_edges<3>; ++i) {
      const int* node = mesh.element(e);
      const auto [a, b] = SimplexEdges<3>::ends[i];
      start.segment<3>(3 * node[4 + i]) =
          0.5 * (start.segment<3>(3 * node[a]) + start.segment<3>(3 * node[b]));
    }
}

// Least determinant at a vertex of an element, over that of the undisplaced one.
double least_determinant(const Mesh<3>& mesh, const Eigen::VectorXd& start, int element) {
  const int* node = mesh.element(element);
  Tensor<3> edges;
  for (int c = 0; c < 3; ++c) edges.col(c) = mesh.node(node[c + 1]) - mesh.node(node[0]);
  const Tensor<3> inverse = edges.inverse();
  std::array<Vector<3>, 4> gradient;
  for (int c = 0; c < 3; ++c) gradient[c + 1] = inverse.row(c);
  gradient[0] = -gradient[1] - gradient[2] - gradient[3];
  double least = 1;
  for (int v = 0; v < 4; ++v) {
    Tensor<3> F = Tensor<3>::Identity();
    for (int a = 0; a < mesh.nodes_per_element; ++a)
      F += start.segment<3>(3 * node[a]) *
           shape_gradient<3, 3>(mesh.nodes_per_element, Barycentric<3>::Unit(v), gradient, a).transpose();
    least = std::min(least, F.determinant());
  }
  return least;
}

// Edges of elements that would be bent too far are bent less.
void straighten(const Mesh<3>& mesh, Eigen::VectorXd& start) {
  for (int halves = 0; halves <= HALVES; ++halves) {
    std::map<int, Vector<3>> bent; // mid nodes, and where their straight edges have them
    for (int e = 0; e < mesh.num_elements; ++e) {
      if (least_determinant(mesh, start, e) > LEAST_DET) continue;
      for (int i = 0; i < num_edges<3>; ++i) {
        const int* node = mesh.element(e);
        const auto [a, b] = SimplexEdges<3>::ends[i];
        bent[node[4 + i]] = 0.5 * (start.segment<3>(3 * node[a]) + start.segment<3>(3 * node[b]));
      }
    }
    if (bent.empty()) return;
    for (const auto& [node, straight] : bent)
      start.segment<3>(3 * node) =
          straight + (halves < HALVES ? 0.5 : 0.) * (start.segment<3>(3 * node) - straight);
  }
}

// What is missing goes to the mid nodes of curved edges, all by the same way along the normal: a third of a face's area each.
void keep_volume(double volume, const Mesh<3>& fresh, const std::map<int, SurfaceNode>& nodes,
                 Eigen::VectorXd& start) {
  double missing = volume, per_way = 0;
  std::set<int> curved;
  for (const BoundaryFace& face : boundary_faces(fresh, start)) {
    missing -= volume_behind(face.x);
    for (int i = 0; i < 3; ++i) {
      const SurfaceNode& at = nodes.at(face.facet.middle[i]);
      const auto [a, b] = SimplexEdges<2>::ends[i];
      const double bulge = (face.x[3 + i] - 0.5 * (face.x[a] + face.x[b])).norm();
      if (at.patches.size() == 1 && bulge > CURVED * at.size) curved.insert(face.facet.middle[i]);
    }
  }
  for (const int node : curved) per_way += nodes.at(node).normal.norm() / 3;
  for (const int node : curved)
    start.segment<3>(3 * node) += missing / per_way * nodes.at(node).normal.normalized();
}

} // namespace

Eigen::VectorXd surface_displacement(const Mesh<3>& old, const Eigen::VectorXd& u, const Mesh<3>& fresh) {
  Eigen::VectorXd start = Eigen::VectorXd::Zero(fresh.num_dofs());
  if (fresh.nodes_per_element == 4) return start;
  const DeformedSurface surface(old, u);
  const std::vector<BoundaryFace> faces = boundary_faces(fresh, start);
  const std::map<int, SurfaceNode> nodes = surface_nodes(surface, faces);
  const auto place = [&](int node) {
    const SurfaceNode& at = nodes.at(node);
    const Vector<3> x = fresh.node(node), moved = surface.common_place(x, at.patches) - x;
    if (moved.norm() < WITHIN * at.size) start.segment<3>(3 * node) = moved;
  };
  for (const BoundaryFace& face : faces)
    for (const int vertex : face.facet.vertex) place(vertex);
  follow_vertices(fresh, start);
  for (const BoundaryFace& face : faces)
    for (const int middle : face.facet.middle) place(middle);
  straighten(fresh, start);
  for (int pass = 0; pass < PASSES; ++pass) {
    keep_volume(surface.volume(), fresh, nodes, start);
    straighten(fresh, start);
  }
  return start;
}

} // namespace burnish
