#pragma once
// Stiffness matrices of elastic bodies on real meshes, for the tests and the benchmark of cxx/solver. Unit
// modulus.
#include "solver/node_block_matrix.hpp"
#include <cmath>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace burnish::sample {

/// Simplices of first or second order; the vertices of an element come before its mid-side nodes.
template <int Dim> struct Mesh {
  std::vector<Vector<Dim>> node;
  int nodes_per_element = Dim + 1;
  std::vector<int> connectivity;
  std::vector<int> inner, outer; ///< nodes on the two opposite faces of the first grid direction
};

/// Edges of a simplex in the order of its mid-side nodes.
template <int Dim> std::vector<std::pair<int, int>> edges() {
  std::vector<std::pair<int, int>> list;
  for (int a = 0; a <= Dim; ++a)
    for (int b = a + 1; b <= Dim; ++b) list.emplace_back(a, b);
  return list;
}

template <int Dim> Mesh<Dim> with_mid_nodes(const Mesh<Dim>& linear) {
  Mesh<Dim> mesh = linear;
  mesh.connectivity.clear();
  mesh.nodes_per_element = (Dim + 1) * (Dim + 2) / 2;
  std::map<std::pair<int, int>, int> mid;
  std::vector<char> on_inner(linear.node.size(), 0), on_outer(linear.node.size(), 0);
  for (int n : linear.inner) on_inner[n] = 1;
  for (int n : linear.outer) on_outer[n] = 1;
  for (std::size_t first = 0; first < linear.connectivity.size(); first += Dim + 1) {
    const int* vertex = &linear.connectivity[first];
    mesh.connectivity.insert(mesh.connectivity.end(), vertex, vertex + Dim + 1);
    for (auto [a, b] : edges<Dim>()) {
      const std::pair<int, int> key = std::minmax(vertex[a], vertex[b]);
      const auto [place, is_new] = mid.emplace(key, static_cast<int>(mesh.node.size()));
      mesh.connectivity.push_back(place->second);
      if (!is_new) continue;
      mesh.node.push_back((mesh.node[key.first] + mesh.node[key.second]) / 2);
      if (on_inner[key.first] && on_inner[key.second]) mesh.inner.push_back(place->second);
      if (on_outer[key.first] && on_outer[key.second]) mesh.outer.push_back(place->second);
    }
  }
  return mesh;
}

/// Ring sector of radii 25 and 30, angle pi/8, in triangles; inner and outer are its arcs. The interior nodes
/// are shifted at random by up to a tenth of a cell.
inline Mesh<2> ring_sector(int num_radial, int num_along) {
  Mesh<2> mesh;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-0.1, 0.1);
  for (int j = 0; j <= num_along; ++j)
    for (int i = 0; i <= num_radial; ++i) {
      const bool is_interior = i > 0 && i < num_radial && j > 0 && j < num_along;
      const double r = 25 + 5 * (i + (is_interior ? shift(random) : 0.)) / num_radial;
      const double angle = M_PI / 8 * (j + (is_interior ? shift(random) : 0.)) / num_along;
      if (i == 0) mesh.inner.push_back(static_cast<int>(mesh.node.size()));
      if (i == num_radial) mesh.outer.push_back(static_cast<int>(mesh.node.size()));
      mesh.node.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
  for (int j = 0; j < num_along; ++j)
    for (int i = 0; i < num_radial; ++i) {
      const int a = j * (num_radial + 1) + i, b = a + 1, c = a + num_radial + 1, d = c + 1;
      for (int n : {a, b, d, a, d, c}) mesh.connectivity.push_back(n);
    }
  return mesh;
}

/// Unit cube of n x n x n cells, each of six tetrahedra; inner and outer are the faces x = 0 and x = 1.
inline Mesh<3> cube(int n) {
  Mesh<3> mesh;
  const auto index = [n](int i, int j, int k) { return (k * (n + 1) + j) * (n + 1) + i; };
  for (int k = 0; k <= n; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) {
        mesh.node.emplace_back(double(i) / n, double(j) / n, double(k) / n);
        if (i == 0) mesh.inner.push_back(index(i, j, k));
        if (i == n) mesh.outer.push_back(index(i, j, k));
      }
  const int path[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        for (const auto& step : path) {
          int at[3] = {i, j, k};
          mesh.connectivity.push_back(index(i, j, k));
          for (int direction : step) {
            ++at[direction];
            mesh.connectivity.push_back(index(at[0], at[1], at[2]));
          }
        }
  return mesh;
}

/// Gradients of the shape functions (nodes_per_element x Dim) at barycentric coordinates l.
template <int Dim>
Eigen::MatrixXd shape_gradients(const Mesh<Dim>& mesh, const Eigen::MatrixXd& vertex_gradients,
                                const Eigen::VectorXd& l) {
  if (mesh.nodes_per_element == Dim + 1) return vertex_gradients;
  Eigen::MatrixXd gradients(mesh.nodes_per_element, Dim);
  for (int a = 0; a <= Dim; ++a) gradients.row(a) = (4 * l[a] - 1) * vertex_gradients.row(a);
  int next = Dim + 1;
  for (auto [a, b] : edges<Dim>())
    gradients.row(next++) = 4 * (l[a] * vertex_gradients.row(b) + l[b] * vertex_gradients.row(a));
  return gradients;
}

/// Isotropic elasticity with lambda = 1.2, G = 1 and a random factor in [0.5, 2] per element; each element
/// also gets `foundation` times its volume on its diagonal, so that the free body is positive definite too
/// (or, if negative and large enough, is not).
template <int Dim>
NodeBlockMatrix<Dim> stiffness(const Mesh<Dim>& mesh, double foundation, unsigned seed = 1) {
  const int per_element = mesh.nodes_per_element, num_nodes = static_cast<int>(mesh.node.size());
  NodeBlockMatrix<Dim> K = pattern_from_elements<Dim>(num_nodes, per_element, mesh.connectivity);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> factor(0.5, 2.);
  const double high = Dim == 2 ? 2. / 3. : 0.5854101966249685, low = (1 - high) / Dim;
  for (std::size_t first = 0; first < mesh.connectivity.size(); first += per_element) {
    const int* element = &mesh.connectivity[first];
    Tensor<Dim> edge;
    for (int d = 0; d < Dim; ++d) edge.col(d) = mesh.node[element[d + 1]] - mesh.node[element[0]];
    Eigen::MatrixXd vertex_gradients(Dim + 1, Dim);
    vertex_gradients.bottomRows(Dim) = edge.inverse();
    vertex_gradients.row(0) = -vertex_gradients.bottomRows(Dim).colwise().sum();
    const double weight = factor(random) * std::abs(edge.determinant()) / (Dim == 2 ? 2 : 6) / (Dim + 1);
    for (int point = 0; point <= Dim; ++point) {
      Eigen::VectorXd l = Eigen::VectorXd::Constant(Dim + 1, low);
      l[point] = high;
      const Eigen::MatrixXd g = shape_gradients(mesh, vertex_gradients, l);
      for (int a = 0; a < per_element; ++a)
        for (int b = 0; b < per_element; ++b) {
          Tensor<Dim> k = 1.2 * g.row(a).transpose() * g.row(b) + g.row(b).transpose() * g.row(a) +
                          g.row(a).dot(g.row(b)) * Tensor<Dim>::Identity();
          if (a == b) k += foundation * Tensor<Dim>::Identity();
          double* block = K.block(K.find(element[a], element[b]));
          for (int i = 0; i < Dim; ++i)
            for (int j = 0; j < Dim; ++j) block[Dim * i + j] += weight * k(i, j);
        }
    }
  }
  return K;
}

template <int Dim> Eigen::MatrixXd dense(const NodeBlockMatrix<Dim>& matrix) {
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(matrix.size(), matrix.size());
  for (int row = 0; row < matrix.num_nodes; ++row)
    for (int k = matrix.row_start[row]; k < matrix.row_start[row + 1]; ++k)
      for (int i = 0; i < Dim; ++i)
        for (int j = 0; j < Dim; ++j)
          full(Dim * row + i, Dim * matrix.col[k] + j) = matrix.block(k)[Dim * i + j];
  return full;
}

/// Flags that fix all dofs of the given nodes.
template <int Dim> std::vector<char> fix(const NodeBlockMatrix<Dim>& matrix, const std::vector<int>& nodes) {
  std::vector<char> fixed(matrix.size(), 0);
  for (int node : nodes)
    for (int c = 0; c < Dim; ++c) fixed[Dim * node + c] = 1;
  return fixed;
}

inline Eigen::VectorXd random_vector(int n, unsigned seed = 3) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> value(-1., 1.);
  return Eigen::VectorXd::NullaryExpr(n, [&]() { return value(random); });
}

/// A sector of a ring, clamped at its inner side.
struct ClampedSector {
  Mesh<2> mesh = with_mid_nodes(ring_sector(4, 8));
  NodeBlockMatrix<2> K = stiffness(mesh, 0.);
  std::vector<char> fixed = fix(K, mesh.inner);
};

} // namespace burnish::sample
