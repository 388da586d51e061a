#include "mesh/discretization.hpp"
#include "base/error.hpp"
#include "mesh/simplex.hpp"
#include <cmath>

namespace burnish {
namespace {

constexpr const char* TRIANGLES = "triangles";

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
    fail(TRIANGLES, what.str());
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
    fail(TRIANGLES, what.str());
  }
}

/// Barycentric coordinates of point q of any element.
Barycentric<2> point_of(const Discretization<2>& mesh, int q) {
  if (mesh.points_per_element == 1) return Barycentric<2>::Constant(1. / 3);
  Barycentric<2> l = Barycentric<2>::Constant(mesh.axisymmetric ? 1. / 6 : 0.5);
  l[q] = 1 - 2 * l[q];
  return l;
}

void add_point(Discretization<2>& mesh, const Triangle& t, const Barycentric<2>& l) {
  const Vector<2> at = l[0] * t.vertex[0] + l[1] * t.vertex[1] + l[2] * t.vertex[2];
  mesh.point.insert(mesh.point.end(), at.begin(), at.end());
  mesh.weight.push_back(t.area / mesh.points_per_element * (mesh.axisymmetric ? 2 * M_PI * at[0] : 1));
  for (int a = 0; a < mesh.nodes_per_element; ++a) {
    const Vector<2> gradient = shape_gradient<2, 2>(mesh.nodes_per_element, l, t.gradient, a);
    mesh.shape_grad.insert(mesh.shape_grad.end(), gradient.begin(), gradient.end());
  }
}

} // namespace

Discretization<2> triangles(Mesh<2> input) {
  require(input.nodes_per_element == 3 || input.nodes_per_element == 6, TRIANGLES, "nodes_per_element",
          input.nodes_per_element, "3 (P1) or 6 (P2)");
  require_valid(input, TRIANGLES);
  Discretization<2> mesh;
  static_cast<Mesh<2>&>(mesh) = std::move(input);
  mesh.points_per_element = mesh.nodes_per_element == 3 ? 1 : 3;
  const std::size_t points = mesh.num_points(), shapes = points * mesh.nodes_per_element;
  mesh.weight.reserve(points);
  mesh.point.reserve(2 * points);
  mesh.shape_grad.reserve(2 * shapes);
  for (int q = 0; q < mesh.points_per_element; ++q) {
    double shape[6];
    shape_functions<2>(mesh.nodes_per_element, point_of(mesh, q), shape);
    mesh.shape.insert(mesh.shape.end(), shape, shape + mesh.nodes_per_element);
  }
  for (int e = 0; e < mesh.num_elements; ++e) {
    const Triangle t = triangle(mesh, e);
    if (mesh.nodes_per_element == 6) check_mid_edges(mesh, e, t);
    for (int q = 0; q < mesh.points_per_element; ++q) add_point(mesh, t, point_of(mesh, q));
  }
  return mesh;
}

Discretization<2> triangles(int nodes_per_element, std::vector<double> X, std::vector<int> connectivity,
                            bool axisymmetric) {
  require(nodes_per_element == 3 || nodes_per_element == 6, TRIANGLES, "nodes_per_element", nodes_per_element,
          "3 (P1) or 6 (P2)");
  require(X.size() % 2 == 0, TRIANGLES, "size of X", X.size(), "an even number, num_nodes x 2");
  Mesh<2> mesh;
  mesh.num_nodes = static_cast<int>(X.size() / 2);
  mesh.nodes_per_element = nodes_per_element;
  mesh.num_elements = static_cast<int>(connectivity.size()) / nodes_per_element;
  mesh.axisymmetric = axisymmetric;
  mesh.X = std::move(X);
  mesh.connectivity = std::move(connectivity);
  return triangles(std::move(mesh));
}

} // namespace burnish
