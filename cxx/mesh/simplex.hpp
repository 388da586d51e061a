#pragma once
// Edges and shape functions of simplices: segment, triangle, tetrahedron, linear (P1) or quadratic (P2).
#include "base/types.hpp"
#include <array>
#include <vector>

namespace burnish {

/// Vertices at both ends of each edge of an N-simplex, in the order of the mid-edge nodes of P2 (FreeFEM's): of a
/// triangle the edges opposite vertex 0, 1, 2.
template <int N> struct SimplexEdges;
template <> struct SimplexEdges<1> { static constexpr std::array<std::array<int, 2>, 1> ends{{{0, 1}}}; };
template <> struct SimplexEdges<2> {
  static constexpr std::array<std::array<int, 2>, 3> ends{{{1, 2}, {2, 0}, {0, 1}}};
};
template <> struct SimplexEdges<3> {
  static constexpr std::array<std::array<int, 2>, 6> ends{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
};
template <int N> inline constexpr int num_edges = static_cast<int>(SimplexEdges<N>::ends.size());

/// Linear N-simplices between neighboring nodes of a P1 or P2 one, as local nodes: itself; of a quadratic segment two, of a
/// quadratic triangle four, the inner one last. @param nodes  nodes of the element
template <int N> const std::vector<std::array<int, N + 1>>& linear_parts(int nodes) {
  static_assert(N == 1 || N == 2);
  using Parts = std::vector<std::array<int, N + 1>>;
  if constexpr (N == 1) {
    static const Parts whole{{0, 1}}, halves{{0, 2}, {2, 1}};
    return nodes == N + 1 ? whole : halves;
  } else {
    static const Parts whole{{0, 1, 2}}, quarters{{0, 5, 4}, {5, 1, 3}, {4, 3, 2}, {3, 4, 5}};
    return nodes == N + 1 ? whole : quarters;
  }
}

/// Barycentric coordinates of a point of an N-simplex [-].
template <int N> using Barycentric = Eigen::Matrix<double, N + 1, 1>;

/// Shape functions of P1 (N + 1 nodes) or P2 (vertices, then mid-edge nodes) at barycentric coordinates l.
/// @param nodes  nodes of the element: N + 1, or N + 1 + number of edges
/// @param values out, one per node [-]
template <int N> void shape_functions(int nodes, const Barycentric<N>& l, double* values) {
  if (nodes == N + 1) {
    for (int a = 0; a <= N; ++a) values[a] = l[a];
    return;
  }
  for (int a = 0; a <= N; ++a) values[a] = l[a] * (2 * l[a] - 1);
  for (int e = 0; e < num_edges<N>; ++e)
    values[N + 1 + e] = 4 * l[SimplexEdges<N>::ends[e][0]] * l[SimplexEdges<N>::ends[e][1]];
}

/// Their gradients from those of the barycentric coordinates.
/// @param gradient dl_a/dX, N + 1 vectors of Dim numbers [1/length]; @param a  node
template <int N, int Dim>
Vector<Dim> shape_gradient(int nodes, const Barycentric<N>& l, const std::array<Vector<Dim>, N + 1>& gradient,
                           int a) {
  if (nodes == N + 1) return gradient[a];
  if (a <= N) return (4 * l[a] - 1) * gradient[a]; // l (2l - 1)
  const auto [i, j] = SimplexEdges<N>::ends[a - N - 1];
  return 4 * (l[i] * gradient[j] + l[j] * gradient[i]); // 4 l_i l_j
}

} // namespace burnish
