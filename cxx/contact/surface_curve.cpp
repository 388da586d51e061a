#include "contact/surface_curve.hpp"
#include "base/error.hpp"
#include "mesh/simplex.hpp"
#include <algorithm>
#include <cmath>
#include <sstream>

namespace burnish {
namespace {

template <int Dim> Eigen::VectorXd places_of_mesh(const Mesh<Dim>& mesh) {
  return Eigen::Map<const Eigen::VectorXd>(mesh.X.data(), static_cast<Eigen::Index>(mesh.X.size()));
}

template <int Dim> Vector<Dim> position(const Mesh<Dim>& mesh, int node) {
  return Eigen::Map<const Vector<Dim>>(&mesh.X[static_cast<std::size_t>(Dim * node)]);
}

// Curvature of an edge between vertices with these.
double between(double k0, double k1) {
  if (k0 * k1 <= 0) return 0;
  if (std::max(std::abs(k0), std::abs(k1)) > 2 * std::min(std::abs(k0), std::abs(k1)))
    return std::abs(k0) < std::abs(k1) ? k0 : k1;
  return 0.5 * (k0 + k1);
}

// Neighbors of every node along the surface, before and after it; -1: none.
struct Neighbors {
  std::vector<int> before, after;
  Neighbors(const Mesh<2>& mesh, const std::vector<Facet<2>>& surface)
      : before(mesh.num_nodes, -1), after(mesh.num_nodes, -1) {
    for (const Facet<2>& edge : surface) {
      after[edge.vertex[0]] = edge.vertex[1];
      before[edge.vertex[1]] = edge.vertex[0];
    }
  }
};

// Curvature at a vertex of the circle through it and its neighbors, positive where the surface turns to the left
// [1/length]; unknown where the surface ends, and at a corner.
struct VertexCurvature {
  double value = 0;
  bool known = false;
};
VertexCurvature at_vertex(const Mesh<2>& mesh, const Neighbors& next, int node, double corner) {
  const int before = next.before[node], after = next.after[node];
  if (before < 0 || after < 0) return {};
  const Vector<2> p = position(mesh, node) - position(mesh, before),
                  q = position(mesh, after) - position(mesh, node);
  const double cross = p[0] * q[1] - p[1] * q[0];
  if (std::abs(std::atan2(cross, p.dot(q))) > corner) return {};
  return {2 * cross / (p.norm() * q.norm() * (p + q).norm()), true};
}

} // namespace

template <>
Eigen::VectorXd places_on_curve<2>(const Mesh<2>& mesh, const std::vector<Facet<2>>& surface, double corner) {
  constexpr double straight = 1e-9; // curvature times length of an edge that is none
  Eigen::VectorXd X = places_of_mesh(mesh);
  const Neighbors next(mesh, surface);
  for (const Facet<2>& edge : surface) {
    if (edge.middle[0] < 0) continue;
    const VertexCurvature k0 = at_vertex(mesh, next, edge.vertex[0], corner),
                          k1 = at_vertex(mesh, next, edge.vertex[1], corner);
    if (!k0.known && !k1.known) continue;
    const double k = !k0.known ? k1.value : !k1.known ? k0.value : between(k0.value, k1.value);
    const Vector<2> chord = position(mesh, edge.vertex[1]) - position(mesh, edge.vertex[0]);
    const double half = 0.5 * chord.norm() * k;
    if (std::abs(half) < straight || std::abs(half) >= 1) continue;
    // a path that turns to the left bulges to the right of its chords
    const double bulge = 0.5 * chord.norm() * half / (1 + std::sqrt(1 - half * half));
    X.segment<2>(2 * edge.middle[0]) += bulge * Vector<2>(chord[1], -chord[0]) / chord.norm();
  }
  return X;
}
template <> Eigen::VectorXd places_on_curve<3>(const Mesh<3>& mesh, const std::vector<Facet<3>>&, double) {
  return places_of_mesh(mesh);
}

template <int Dim>
Eigen::VectorXd places_given(const Mesh<Dim>& mesh, const std::vector<Facet<Dim>>& surface,
                             const Eigen::VectorXd& places) {
  constexpr double farthest = 0.25;
  require(places.size() == mesh.num_dofs(), "contact", "size of surfaceplaces", places.size(),
          "one entry per degree of freedom");
  Eigen::VectorXd X = places_of_mesh(mesh);
  for (const Facet<Dim>& facet : surface)
    for (std::size_t e = 0; e < facet.middle.size(); ++e) {
      const int node = facet.middle[e];
      if (node < 0) continue;
      const auto& ends = SimplexEdges<Dim - 1>::ends[e];
      const double length =
          (position(mesh, facet.vertex[ends[1]]) - position(mesh, facet.vertex[ends[0]])).norm();
      const Vector<Dim> place = places.template segment<Dim>(Dim * node);
      const double distance = (place - position(mesh, node)).norm();
      if (!(distance <= farthest * length)) {
        std::ostringstream what;
        what << "surfaceplaces of node " << node << " lies " << distance
             << " from the middle of its edge, which is " << length
             << " long, expected at most a quarter of it";
        fail("contact", what.str());
      }
      X.template segment<Dim>(Dim * node) = place;
    }
  return X;
}

template Eigen::VectorXd places_given<2>(const Mesh<2>&, const std::vector<Facet<2>>&,
                                         const Eigen::VectorXd&);
template Eigen::VectorXd places_given<3>(const Mesh<3>&, const std::vector<Facet<3>>&,
                                         const Eigen::VectorXd&);

} // namespace burnish
