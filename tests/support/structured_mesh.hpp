#pragma once
// Structured triangle meshes for the tests: a block and a ring sector, clamped below, contact above.
#include "geometry/plane.hpp"
#include "mesh/discretization.hpp"
#include <cmath>
#include <map>

namespace burnish::test {

/// A mesh with what a contact problem needs to know of its boundary.
struct ContactMesh {
  Discretization<2> space;
  std::vector<Facet<2>> surface; ///< upper side, from left to right in grid coordinates
  std::vector<char> fixed;       ///< lower side clamped
};

namespace detail {

/// Corner nodes of one grid line.
inline std::vector<int> grid_line(int nx, int j) {
  std::vector<int> line;
  for (int i = 0; i <= nx; ++i) line.push_back(j * (nx + 1) + i);
  return line;
}

/// Mid-edge nodes after each triangle's corners; `middle` maps an edge to its new node.
inline std::vector<int> quadratic(const std::vector<int>& corners, std::vector<double>& X,
                                  std::map<std::pair<int, int>, int>& middle) {
  std::vector<int> connectivity;
  for (std::size_t first = 0; first < corners.size(); first += 3) {
    const int* c = &corners[first];
    connectivity.insert(connectivity.end(), c, c + 3);
    for (int v = 0; v < 3; ++v) {
      const std::pair<int, int> edge = std::minmax(c[(v + 1) % 3], c[(v + 2) % 3]);
      const auto [place, fresh] = middle.emplace(edge, static_cast<int>(X.size() / 2));
      connectivity.push_back(place->second);
      if (!fresh) continue;
      X.push_back((X[2 * edge.first] + X[2 * edge.second]) / 2);
      X.push_back((X[2 * edge.first + 1] + X[2 * edge.second + 1]) / 2);
    }
  }
  return connectivity;
}

} // namespace detail

/// nx x ny cells of two triangles each (diagonals alternate); position(xi, eta) maps the unit square, keeping
/// its orientation. @param order 1 or 2
template <class Position> ContactMesh structured_mesh(int nx, int ny, int order, const Position& position) {
  std::vector<double> X;
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) {
      const Vector<2> x = position(static_cast<double>(i) / nx, static_cast<double>(j) / ny);
      X.insert(X.end(), {x[0], x[1]});
    }
  std::vector<int> corners;
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const int a = j * (nx + 1) + i, b = a + 1, c = b + nx + 1, d = a + nx + 1;
      if ((i + j) % 2)
        corners.insert(corners.end(), {a, b, c, a, c, d});
      else
        corners.insert(corners.end(), {a, b, d, b, c, d});
    }
  std::map<std::pair<int, int>, int> middle;
  if (order == 2) corners = detail::quadratic(corners, X, middle);
  ContactMesh mesh;
  mesh.fixed.assign(X.size(), 0);
  const auto hold = [&](int node) { mesh.fixed[2 * node] = mesh.fixed[2 * node + 1] = 1; };
  const std::vector<int> bottom = detail::grid_line(nx, 0), top = detail::grid_line(nx, ny);
  for (int i = 0; i < nx; ++i) {
    Facet<2> facet{{top[i + 1], top[i]}, {-1}, 2 * ((ny - 1) * nx + i) + 1};
    if (order == 2) facet.middle[0] = middle.at({top[i], top[i + 1]});
    mesh.surface.push_back(facet);
    if (order == 2) hold(middle.at({bottom[i], bottom[i + 1]}));
  }
  for (const int node : bottom) hold(node);
  mesh.space = triangles(order == 2 ? 6 : 3, X, corners);
  return mesh;
}

/// Block 0 <= x <= width, 0 <= y <= height, turned by `angle` about `pivot`.
inline ContactMesh block_mesh(int nx, int ny, int order, double width, double height, double angle = 0,
                              const Vector<2>& pivot = Vector<2>::Zero()) {
  return structured_mesh(nx, ny, order, [&](double xi, double eta) {
    return Vector<2>(pivot + plane_rotation(angle) * (Vector<2>(width * xi, height * eta) - pivot));
  });
}

/// Ring sector about the origin with its middle at 90 degrees, inner arc clamped, outer arc in contact; cells
/// graded towards the outer arc: the innermost is `grading` times as thick as the outermost.
inline ContactMesh ring_mesh(int along, int across, int order, double inner, double outer, double opening,
                             double grading) {
  const double g = std::pow(grading, 1. / std::max(across - 1, 1));
  return structured_mesh(along, across, order, [&](double xi, double eta) {
    // thicknesses fall by the factor g from cell to cell
    const double f = g == 1 ? eta : (1 - std::pow(g, -eta * across)) / (1 - std::pow(g, -across));
    const double angle = M_PI / 2 + opening * (0.5 - xi);
    return Vector<2>((inner + (outer - inner) * f) * plane_direction(angle));
  });
}

} // namespace burnish::test
