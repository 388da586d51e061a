#pragma once
// A small distorted patch of triangles, and fields on it.
#include "material/j2/law.hpp"
#include "workpiece/workpiece.hpp"
#include <map>
#include <vector>

namespace burnish::test {

/// Square of the given side at (0,0), 3 x 3 vertices with the middle one and those of the sides moved, 8
/// triangles. Vertex 3j + i, i along x; P2 has the mid-edge nodes after the vertices.
inline Discretization<2> patch(int nodes_per_element, double side) {
  std::vector<double> X = {0, 0, 0.45, 0, 1, 0, 0, 0.55, 0.57, 0.46, 1, 0.42, 0, 1, 0.6, 1, 1, 1};
  for (double& x : X) x *= side;
  const int corners[8][3] = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4},
                             {3, 4, 7}, {3, 7, 6}, {4, 5, 8}, {4, 8, 7}};
  std::vector<int> connectivity;
  std::map<std::pair<int, int>, int> mid;
  for (const auto& corner : corners) {
    connectivity.insert(connectivity.end(), corner, corner + 3);
    if (nodes_per_element == 3) continue;
    for (int v = 0; v < 3; ++v) {
      const int a = corner[(v + 1) % 3], b = corner[(v + 2) % 3];
      const auto [place, is_new] = mid.emplace(std::minmax(a, b), static_cast<int>(X.size() / 2));
      connectivity.push_back(place->second);
      if (!is_new) continue;
      X.push_back((X[2 * a] + X[2 * b]) / 2);
      X.push_back((X[2 * a + 1] + X[2 * b + 1]) / 2);
    }
  }
  return triangles(nodes_per_element, X, connectivity);
}

/// Displacement (F - I) X of a homogeneous deformation.
inline Eigen::VectorXd homogeneous(const Discretization<2>& mesh, const Tensor<2>& F) {
  Eigen::VectorXd u(mesh.num_dofs());
  for (int a = 0; a < mesh.num_nodes; ++a) u.segment<2>(2 * a) = (F - Tensor<2>::Identity()) * mesh.node(a);
  return u;
}

/// Displacement with strains and rotations of about `size` that change over the body of the given side.
inline Eigen::VectorXd bent(const Discretization<2>& mesh, double side, double size) {
  Eigen::VectorXd u(mesh.num_dofs());
  for (int a = 0; a < mesh.num_nodes; ++a) {
    const Vector<2> x = mesh.node(a) / side;
    u[2 * a] = size * side * (x[0] + 0.7 * x[1] + 0.8 * x[0] * x[1]);
    u[2 * a + 1] = size * side * (0.3 * x[0] - 0.6 * x[1] - 0.5 * x[0] * x[0]);
  }
  return u;
}

/// Every numbered array of a state, for comparing states.
inline bool same(const WorkpieceState<2>& a, const WorkpieceState<2>& b) {
  return a.displacement == b.displacement && a.F == b.F && a.stress == b.stress && a.internal == b.internal &&
         a.strain_increment == b.strain_increment && a.plastic == b.plastic && a.dt == b.dt &&
         a.integrity == b.integrity && a.integrity_rate == b.integrity_rate &&
         a.integrity_goal == b.integrity_goal;
}

inline Gradient<2> gradient_at(const WorkpieceState<2>& state, int point) {
  return Eigen::Map<const Gradient<2>>(state.F.data() + 5 * point);
}

inline Stress<2> stress_at(const WorkpieceState<2>& state, int point) {
  return Eigen::Map<const Stress<2>>(state.stress.data() + 4 * point);
}

/// ep of a J2 body: its only internal variable.
inline double plastic_strain_eq_at(const WorkpieceState<2>& state, int point) {
  return state.internal[point];
}

} // namespace burnish::test
