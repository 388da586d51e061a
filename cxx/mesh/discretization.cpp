#include "mesh/discretization.hpp"
#include "base/error.hpp"
#include "mesh/simplex.hpp"
#include <cmath>

namespace burnish {
namespace {

constexpr const char* TRIANGLES = "triangles";
constexpr const char* TETRAHEDRA = "tetrahedra";

/// Area or volume of an element's simplex and the gradients of its barycentric coordinates.
template <int Dim> struct Simplex {
  double size;
  std::array<Vector<Dim>, Dim + 1> vertex, gradient;
};

void set_gradients(Simplex<2>& t) { // normal of the opposite edge, inwards, over twice the area
  for (int v = 0; v < 3; ++v) {
    const Vector<2> edge = t.vertex[(v + 2) % 3] - t.vertex[(v + 1) % 3];
    t.gradient[v] = Vector<2>(-edge[1], edge[0]) / (2 * t.size);
  }
}
void set_gradients(Simplex<3>& t) { // normal of the opposite face, inwards, over three times the volume
  constexpr int face[4][3] = {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}};
  for (int v = 0; v < 4; ++v) {
    const Vector<3>&a = t.vertex[face[v][0]], &b = t.vertex[face[v][1]], &c = t.vertex[face[v][2]];
    t.gradient[v] = (b - a).cross(c - a) / (6 * t.size);
  }
}

template <int Dim> Simplex<Dim> simplex(const Discretization<Dim>& mesh, int e) {
  Simplex<Dim> t;
  for (int v = 0; v <= Dim; ++v) t.vertex[v] = mesh.node(mesh.element(e)[v]);
  t.size = signed_size(mesh, e);
  set_gradients(t);
  return t;
}

template <int Dim>
void check_mid_edges(const Discretization<Dim>& mesh, int e, const Simplex<Dim>& t, const char* where) {
  constexpr double tolerance = 1e-6; // of the edge's length: what a mesh file's digits can cost
  for (int k = 0; k < num_edges<Dim>; ++k) {
    const auto [i, j] = SimplexEdges<Dim>::ends[k];
    const Vector<Dim>&a = t.vertex[i], &b = t.vertex[j];
    const int node = mesh.element(e)[Dim + 1 + k];
    const double offset = (mesh.node(node) - 0.5 * (a + b)).norm() / (b - a).norm();
    if (offset <= tolerance) continue;
    std::ostringstream what;
    what << "node " << node << " of element " << e << " is off the middle of the edge ";
    if (Dim == 2)
      what << "opposite vertex " << k;
    else
      what << "from vertex " << i << " to " << j;
    what << " by " << offset << " of its length, expected the middle (straight sides)";
    fail(where, what.str());
  }
}

/// Barycentric coordinates of point q of any element.
Barycentric<2> point_of(const Discretization<2>& mesh, int q) {
  if (mesh.points_per_element == 1) return Barycentric<2>::Constant(1. / 3);
  Barycentric<2> l = Barycentric<2>::Constant(mesh.axisymmetric ? 1. / 6 : 0.5);
  l[q] = 1 - 2 * l[q];
  return l;
}
Barycentric<3> point_of(const Discretization<3>& mesh, int q) {
  if (mesh.points_per_element == 1) return Barycentric<3>::Constant(0.25);
  constexpr double others = 0.1381966011250105; // (5 - sqrt(5))/20; the largest one is 0.5854101966249685
  Barycentric<3> l = Barycentric<3>::Constant(others);
  l[(q + 1) % 4] = 1 - 3 * others; // the order of FEQF23d
  return l;
}

template <int Dim>
void add_point(Discretization<Dim>& mesh, const Simplex<Dim>& t, const Barycentric<Dim>& l) {
  Vector<Dim> at = l[0] * t.vertex[0];
  for (int v = 1; v <= Dim; ++v) at += l[v] * t.vertex[v];
  mesh.point.insert(mesh.point.end(), at.begin(), at.end());
  mesh.weight.push_back(t.size / mesh.points_per_element * (mesh.axisymmetric ? 2 * M_PI * at[0] : 1));
  for (int a = 0; a < mesh.nodes_per_element; ++a) {
    const Vector<Dim> gradient = shape_gradient<Dim, Dim>(mesh.nodes_per_element, l, t.gradient, a);
    mesh.shape_grad.insert(mesh.shape_grad.end(), gradient.begin(), gradient.end());
  }
}

template <int Dim> Discretization<Dim> discretized(Mesh<Dim> input, const char* where) {
  constexpr int quadratic = Dim + 1 + num_edges<Dim>;
  require_valid(input, where);
  Discretization<Dim> mesh;
  static_cast<Mesh<Dim>&>(mesh) = std::move(input);
  mesh.points_per_element = mesh.nodes_per_element == quadratic ? Dim + 1 : 1;
  const std::size_t points = mesh.num_points(), shapes = points * mesh.nodes_per_element;
  mesh.weight.reserve(points);
  mesh.point.reserve(Dim * points);
  mesh.shape_grad.reserve(Dim * shapes);
  for (int q = 0; q < mesh.points_per_element; ++q) {
    double shape[quadratic];
    shape_functions<Dim>(mesh.nodes_per_element, point_of(mesh, q), shape);
    mesh.shape.insert(mesh.shape.end(), shape, shape + mesh.nodes_per_element);
  }
  for (int e = 0; e < mesh.num_elements; ++e) {
    const Simplex<Dim> t = simplex(mesh, e);
    if (mesh.nodes_per_element == quadratic) check_mid_edges(mesh, e, t, where);
    for (int q = 0; q < mesh.points_per_element; ++q) add_point(mesh, t, point_of(mesh, q));
  }
  return mesh;
}

} // namespace

Discretization<2> triangles(Mesh<2> mesh) {
  require(mesh.nodes_per_element == 3 || mesh.nodes_per_element == 6, TRIANGLES, "nodes_per_element",
          mesh.nodes_per_element, "3 (P1) or 6 (P2)");
  return discretized(std::move(mesh), TRIANGLES);
}

Discretization<3> tetrahedra(Mesh<3> mesh) {
  require(mesh.nodes_per_element == 4 || mesh.nodes_per_element == 10, TETRAHEDRA, "nodes_per_element",
          mesh.nodes_per_element, "4 (P1) or 10 (P2)");
  require(!mesh.axisymmetric, TETRAHEDRA, "axisymmetric", mesh.axisymmetric, "0: such meshes are plane ones");
  return discretized(std::move(mesh), TETRAHEDRA);
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

template <int Dim> void require_sizes(const Discretization<Dim>& mesh, const char* where) {
  const std::size_t points = static_cast<std::size_t>(std::max(0, mesh.num_points()));
  const std::size_t per_point = static_cast<std::size_t>(std::max(0, mesh.nodes_per_element)) * Dim;
  require(mesh.num_elements > 0, where, "num_elements", mesh.num_elements, "> 0");
  require(mesh.nodes_per_element > Dim, where, "nodes_per_element", mesh.nodes_per_element, "> Dim");
  require(mesh.points_per_element > 0, where, "points_per_element", mesh.points_per_element, "> 0");
  const std::size_t nodes = static_cast<std::size_t>(std::max(0, mesh.num_nodes));
  require(mesh.X.size() == Dim * nodes, where, "size of X", mesh.X.size(), "num_nodes x Dim");
  require(mesh.connectivity.size() == static_cast<std::size_t>(mesh.num_elements) * mesh.nodes_per_element,
          where, "size of connectivity", mesh.connectivity.size(), "num_elements x nodes_per_element");
  require(mesh.weight.size() == points, where, "size of weight", mesh.weight.size(), "num_points");
  require(mesh.shape_grad.size() == points * per_point, where, "size of shape_grad", mesh.shape_grad.size(),
          "num_points x nodes_per_element x Dim");
  require(mesh.shape.size() * Dim == per_point * mesh.points_per_element, where, "size of shape",
          mesh.shape.size(), "points_per_element x nodes_per_element");
  require(mesh.point.size() == points * Dim, where, "size of point", mesh.point.size(), "num_points x Dim");
  if (mesh.axisymmetric && Dim == 3) fail(where, "axisymmetric meshes are plane ones");
}

template void require_sizes<2>(const Discretization<2>&, const char*);
template void require_sizes<3>(const Discretization<3>&, const char*);

} // namespace burnish
