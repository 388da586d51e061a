#include "mesh/discretization.hpp"
#include "base/error.hpp"
#include <algorithm>
#include <array>
#include <cmath>

namespace burnish {
namespace {

constexpr const char* WHERE = "triangles";

void check_input(const Discretization<2>& mesh) {
  const int per_element = mesh.nodes_per_element;
  require(per_element == 3 || per_element == 6, WHERE, "nodes_per_element", per_element, "3 (P1) or 6 (P2)");
  require(mesh.X.size() % 2 == 0, WHERE, "size of X", mesh.X.size(), "an even number, num_nodes x 2");
  require(!mesh.connectivity.empty() && mesh.connectivity.size() % per_element == 0, WHERE,
          "size of connectivity", mesh.connectivity.size(), "a positive multiple of nodes_per_element");
  for (std::size_t k = 0; k < mesh.X.size(); ++k) {
    if (std::isfinite(mesh.X[k])) continue;
    std::ostringstream what;
    what << "X of node " << k / 2 << ", component " << k % 2 << " = " << mesh.X[k]
         << ", expected a finite number";
    fail(WHERE, what.str());
  }
  for (std::size_t k = 0; k < mesh.connectivity.size(); ++k) {
    const int node = mesh.connectivity[k];
    if (node >= 0 && node < mesh.num_nodes) continue;
    std::ostringstream what;
    what << "node of element " << k / per_element << " = " << node << ", expected 0 <= node < "
         << mesh.num_nodes;
    fail(WHERE, what.str());
  }
}

void check_radii(const Discretization<2>& mesh) {
  double size = 0;
  for (const double x : mesh.X) size = std::max(size, std::abs(x));
  for (int a = 0; a < mesh.num_nodes; ++a) {
    if (mesh.node(a)[0] >= -1e-12 * size) continue;
    std::ostringstream what;
    what << "x of node " << a << " = " << mesh.node(a)[0]
         << ", expected a radius >= 0 (axisymmetric: the axis is x = 0)";
    fail(WHERE, what.str());
  }
}

/// Signed area of an element's triangle and the gradients of its barycentric coordinates.
struct Triangle {
  double area;
  std::array<Vector<2>, 3> vertex, gradient;
};

Triangle triangle(const Discretization<2>& mesh, int e) {
  Triangle t;
  for (int v = 0; v < 3; ++v) t.vertex[v] = mesh.node(mesh.element(e)[v]);
  const Vector<2> a = t.vertex[1] - t.vertex[0], b = t.vertex[2] - t.vertex[0];
  t.area = 0.5 * (a[0] * b[1] - a[1] * b[0]);
  if (!(t.area > 0)) {
    std::ostringstream what;
    what << "area of element " << e << " = " << t.area << ", expected > 0 (vertices counter-clockwise)";
    fail(WHERE, what.str());
  }
  for (int v = 0; v < 3; ++v) { // normal of the opposite edge, inwards, over twice the area
    const Vector<2> edge = t.vertex[(v + 2) % 3] - t.vertex[(v + 1) % 3];
    t.gradient[v] = Vector<2>(-edge[1], edge[0]) / (2 * t.area);
  }
  return t;
}

void check_mid_edges(const Discretization<2>& mesh, int e, const Triangle& t) {
  constexpr double tolerance = 1e-6; // of the edge's length: what a mesh file's digits can cost
  for (int v = 0; v < 3; ++v) {
    const Vector<2>&a = t.vertex[(v + 1) % 3], &b = t.vertex[(v + 2) % 3];
    const int node = mesh.element(e)[3 + v];
    const double offset = (mesh.node(node) - 0.5 * (a + b)).norm() / (b - a).norm();
    if (offset <= tolerance) continue;
    std::ostringstream what;
    what << "node " << node << " of element " << e << " is off the middle of the edge opposite vertex " << v
         << " by " << offset << " of its length, expected the middle (straight sides)";
    fail(WHERE, what.str());
  }
}

/// Barycentric coordinates of point q of an element.
std::array<double, 3> point_of(const Discretization<2>& mesh, int q) {
  if (mesh.points_per_element == 1) return {1. / 3, 1. / 3, 1. / 3};
  std::array<double, 3> l;
  l.fill(mesh.axisymmetric ? 1. / 6 : 0.5);
  l[q] = 1 - 2 * l[q];
  return l;
}

/// N_a of P1 (a < 3) or P2 at barycentric coordinates l.
double shape(int nodes_per_element, const std::array<double, 3>& l, int a) {
  if (nodes_per_element == 3) return l[a];
  return a < 3 ? l[a] * (2 * l[a] - 1)
               : 4 * l[(a + 1) % 3] * l[(a + 2) % 3]; // the edge opposite vertex a - 3
}

/// dN_a/dX there.
Vector<2> shape_gradient(const Triangle& t, int nodes_per_element, const std::array<double, 3>& l, int a) {
  if (nodes_per_element == 3) return t.gradient[a];
  if (a < 3) return (4 * l[a] - 1) * t.gradient[a]; // l (2l - 1)
  const int i = (a + 1) % 3, j = (a + 2) % 3;       // 4 l_i l_j
  return 4 * (l[i] * t.gradient[j] + l[j] * t.gradient[i]);
}

void add_point(Discretization<2>& mesh, const Triangle& t, const std::array<double, 3>& l) {
  const Vector<2> at = l[0] * t.vertex[0] + l[1] * t.vertex[1] + l[2] * t.vertex[2];
  mesh.point.insert(mesh.point.end(), at.begin(), at.end());
  mesh.weight.push_back(t.area / mesh.points_per_element * (mesh.axisymmetric ? 2 * M_PI * at[0] : 1));
  for (int a = 0; a < mesh.nodes_per_element; ++a) {
    mesh.shape.push_back(shape(mesh.nodes_per_element, l, a));
    const Vector<2> gradient = shape_gradient(t, mesh.nodes_per_element, l, a);
    mesh.shape_grad.insert(mesh.shape_grad.end(), gradient.begin(), gradient.end());
  }
}

} // namespace

Discretization<2> triangles(int nodes_per_element, std::vector<double> X, std::vector<int> connectivity,
                            bool axisymmetric) {
  Discretization<2> mesh;
  mesh.num_nodes = static_cast<int>(X.size() / 2);
  mesh.nodes_per_element = nodes_per_element;
  mesh.axisymmetric = axisymmetric;
  mesh.X = std::move(X);
  mesh.connectivity = std::move(connectivity);
  check_input(mesh);
  if (axisymmetric) check_radii(mesh);
  mesh.points_per_element = nodes_per_element == 3 ? 1 : 3;
  mesh.num_elements = static_cast<int>(mesh.connectivity.size()) / nodes_per_element;
  const std::size_t points = mesh.num_points(), shapes = points * nodes_per_element;
  mesh.weight.reserve(points);
  mesh.point.reserve(2 * points);
  mesh.shape.reserve(shapes);
  mesh.shape_grad.reserve(2 * shapes);
  for (int e = 0; e < mesh.num_elements; ++e) {
    const Triangle t = triangle(mesh, e);
    if (nodes_per_element == 6) check_mid_edges(mesh, e, t);
    for (int q = 0; q < mesh.points_per_element; ++q) add_point(mesh, t, point_of(mesh, q));
  }
  return mesh;
}

} // namespace burnish
