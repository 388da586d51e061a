#pragma once
// Small meshes of tetrahedra.
#include "mesh/discretization.hpp"
#include "mesh/simplex.hpp"
#include <algorithm>
#include <cmath>
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

/// Ascending divisions of an edge of a block: even from a to b, then growing by `ratio` out to A and B.
inline std::vector<double> divisions(double a, double b, double h, double ratio = 1.6, double A = NAN,
                                     double B = NAN) {
  const int n = std::max(1, static_cast<int>(std::lround((b - a) / h)));
  std::vector<double> at;
  for (int i = 0; i <= n; ++i) at.push_back(a + (b - a) * i / n);
  const auto grow = [&](double to, double sign) {
    for (double step = ratio * (b - a) / n; sign * (to - at.back()) > 1e-9; step *= ratio) {
      const double next = at.back() + sign * step;
      at.push_back(sign * (to - next) < 0.5 * step * ratio ? to : next);
    }
  };
  if (B > b) grow(B, 1);
  if (A < a) {
    std::reverse(at.begin(), at.end());
    grow(A, -1);
    std::reverse(at.begin(), at.end());
  }
  return at;
}

/// Block of cells of six tetrahedra each (Kuhn), with its top facets (largest z), label 1.
/// @param x, y, z ascending divisions; @param nodes_per_element 4 or 10; @param mirrored from cell to cell: inner vertices of
/// the top have 4 and 8 facets in turn, else 6
inline Mesh<3> block_of_tetrahedra(const std::vector<double>& x, const std::vector<double>& y,
                                   const std::vector<double>& z, int nodes_per_element,
                                   bool mirrored = true) {
  const int nx = static_cast<int>(x.size()), ny = static_cast<int>(y.size()), nz = static_cast<int>(z.size());
  std::vector<double> X;
  for (const double c : z)
    for (const double b : y)
      for (const double a : x) X.insert(X.end(), {a, b, c});
  const int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  std::vector<int> connectivity;
  for (int k = 0; k + 1 < nz; ++k)
    for (int j = 0; j + 1 < ny; ++j)
      for (int i = 0; i + 1 < nx; ++i)
        for (const auto& order : orders) {
          const std::array<int, 3> cell = {i, j, k};
          std::array<int, 3> way = {0, 0, 0};
          std::array<int, 4> corner;
          for (int c = 0; c < 4; ++c) {
            std::array<int, 3> at;
            for (int d = 0; d < 3; ++d) at[d] = cell[d] + (mirrored && cell[d] % 2 ? 1 - way[d] : way[d]);
            corner[c] = at[0] + nx * (at[1] + ny * at[2]);
            if (c < 3) way[order[c]] = 1;
          }
          const auto place = [&](int a) { return Eigen::Map<const Vector<3>>(X.data() + 3 * a); };
          const Vector<3> o = place(corner[0]);
          if ((place(corner[1]) - o).cross(place(corner[2]) - o).dot(place(corner[3]) - o) < 0)
            std::swap(corner[1], corner[2]);
          connectivity.insert(connectivity.end(), corner.begin(), corner.end());
        }
  const Mesh<3> linear = linear_tetrahedra(X, connectivity);
  Mesh<3> mesh = nodes_per_element == 4 ? linear : quadratic_tetrahedra(linear);
  constexpr int face[4][3] = {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}};
  for (int e = 0; e < mesh.num_elements; ++e)
    for (const auto& corners : face) {
      Facet<3> facet{{-1, -1, -1}, {-1, -1, -1}, e, 1};
      bool top = true;
      for (int c = 0; c < 3; ++c) {
        facet.vertex[c] = mesh.element(e)[corners[c]];
        top = top && mesh.node(facet.vertex[c])[2] > z.back() - 1e-12;
      }
      for (int m = 0; m < 3 && nodes_per_element == 10; ++m)
        for (int k = 0; k < 6; ++k) {
          const auto [a, b] = SimplexEdges<3>::ends[k];
          const auto [i, j] = SimplexEdges<2>::ends[m];
          if (std::minmax(a, b) == std::minmax(corners[i], corners[j]))
            facet.middle[m] = mesh.element(e)[4 + k];
        }
      if (top) mesh.facets.push_back(facet);
    }
  return mesh;
}

/// Linear tetrahedra of a block of nx x ny x nz cells, six a cell about its diagonal; map(xi, eta, zeta) leads from the unit
/// cube to the body.
template <class Map> Mesh<3> block_of_tetrahedra(int nx, int ny, int nz, const Map& map) {
  constexpr int ways[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}};
  const int n[3] = {nx, ny, nz};
  const auto node = [&](const int* i) { return (i[2] * (ny + 1) + i[1]) * (nx + 1) + i[0]; };
  std::vector<double> X;
  std::vector<int> connectivity;
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i) {
        const Vector<3> x = map(1. * i / nx, 1. * j / ny, 1. * k / nz);
        X.insert(X.end(), x.data(), x.data() + 3);
      }
  for (int cell = 0; cell < nx * ny * nz; ++cell)
    for (int w = 0; w < 6; ++w) {
      int at[3] = {cell % n[0], cell / n[0] % n[1], cell / (n[0] * n[1])};
      std::vector<int> corners{node(at)};
      for (const int axis : ways[w]) {
        ++at[axis];
        corners.push_back(node(at));
      }
      if (w >= 3) std::swap(corners[1], corners[2]); // odd ways
      connectivity.insert(connectivity.end(), corners.begin(), corners.end());
    }
  return linear_tetrahedra(std::move(X), std::move(connectivity));
}

/// Displacement (F - I) X of a homogeneous deformation.
inline Eigen::VectorXd homogeneous(const Discretization<3>& mesh, const Tensor<3>& F) {
  Eigen::VectorXd u(mesh.num_dofs());
  for (int a = 0; a < mesh.num_nodes; ++a) u.segment<3>(3 * a) = (F - Tensor<3>::Identity()) * mesh.node(a);
  return u;
}

} // namespace burnish::test
