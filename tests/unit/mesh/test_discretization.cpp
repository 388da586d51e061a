#include "mesh/discretization.hpp"
#include "unit/finite_difference.hpp"
#include "unit/workpiece/patch.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

using Points = std::vector<double>;

/// Quadrature of f over the mesh.
template <class Function> double integral(const Discretization<2>& mesh, const Function& f) {
  double sum = 0;
  for (int p = 0; p < mesh.num_points(); ++p)
    sum += mesh.weight[p] * f(mesh.point[2 * p], mesh.point[2 * p + 1]);
  return sum;
}

/// The patch with its lower left corner at x = r, y = 0: a ring, or a cylinder for r = 0.
Discretization<2> ring(int nodes_per_element, double r) {
  const Discretization<2> plane = patch(nodes_per_element, 1);
  std::vector<double> X = plane.X;
  for (std::size_t k = 0; k < X.size(); k += 2) X[k] += r;
  return triangles(nodes_per_element, X, plane.connectivity, true);
}

/// Value at a point of the interpolation of f.
template <class Function> double value(const Discretization<2>& mesh, int p, const Function& f) {
  double sum = 0;
  const int* node = mesh.element(p / mesh.points_per_element);
  for (int a = 0; a < mesh.nodes_per_element; ++a)
    sum += mesh.shapes(p)[a] * f(mesh.node(node[a])[0], mesh.node(node[a])[1]);
  return sum;
}

/// Gradient at a point of the interpolation of f.
template <class Function> Vector<2> gradient(const Discretization<2>& mesh, int p, const Function& f) {
  Vector<2> sum = Vector<2>::Zero();
  const int* node = mesh.element(p / mesh.points_per_element);
  for (int a = 0; a < mesh.nodes_per_element; ++a) {
    const Vector<2> X = mesh.node(node[a]);
    sum += f(X[0], X[1]) * Eigen::Map<const Vector<2>>(mesh.gradients(p) + 2 * a);
  }
  return sum;
}

const Points TRIANGLE = {0, 0, 2, 0, 0, 1};

} // namespace

TEST(Triangles, Sizes) {
  for (int nodes : {3, 6}) {
    const Discretization<2> mesh = patch(nodes, 1);
    EXPECT_EQ(mesh.num_elements, 8);
    EXPECT_EQ(mesh.points_per_element, nodes / 2);
    EXPECT_EQ(mesh.num_nodes, nodes == 3 ? 9 : 25);
    EXPECT_EQ(mesh.weight.size(), std::size_t(mesh.num_points()));
    EXPECT_EQ(mesh.point.size(), std::size_t(2 * mesh.num_points()));
    EXPECT_EQ(mesh.shape.size(), std::size_t(nodes * mesh.points_per_element));
    EXPECT_EQ(mesh.shape_grad.size(), std::size_t(2 * nodes * mesh.num_points()));
  }
}

TEST(Triangles, PointsOfFreeFem) {
  const Discretization<2> linear = triangles(3, TRIANGLE, {0, 1, 2});
  expect_close(Vector<2>(linear.point[0], linear.point[1]), Vector<2>(2. / 3, 1. / 3), 1, 1e-15, "centroid");
  EXPECT_DOUBLE_EQ(linear.weight[0], 1);
  const Discretization<2> quadratic =
      triangles(6, {0, 0, 2, 0, 0, 1, 1, 0.5, 0, 0.5, 1, 0}, {0, 1, 2, 3, 4, 5});
  for (int q = 0; q < 3; ++q) { // point q = mid-edge node opposite vertex q
    expect_close(Vector<2>(quadratic.point[2 * q], quadratic.point[2 * q + 1]), quadratic.node(3 + q), 1,
                 1e-15, "point");
    EXPECT_DOUBLE_EQ(quadratic.weight[q], 1. / 3);
  }
}

TEST(Triangles, QuadratureIsExactToItsDegree) { // over the square of side 2 at (0,0)
  for (int nodes : {3, 6}) {
    const Discretization<2> mesh = patch(nodes, 2);
    EXPECT_NEAR(integral(mesh, [](double, double) { return 1; }), 4, 1e-14);
    EXPECT_NEAR(integral(mesh, [](double x, double y) { return 3 * x - y; }), 8, 1e-14);
    const double second = integral(mesh, [](double x, double y) { return x * x + x * y; });
    if (nodes == 6) {
      EXPECT_NEAR(second, 16. / 3 + 4, 1e-14);
    }
    if (nodes == 3) {
      EXPECT_GT(std::abs(second - 16. / 3 - 4), 1e-2);
    }
  }
}

TEST(Triangles, ShapesAndGradientsReproduceTheirPolynomials) {
  const auto linear = [](double x, double y) { return 2 * x - 3 * y + 1; };
  const auto quadratic = [](double x, double y) { return x * x - 2 * x * y + 3 * y * y + x; };
  for (const Discretization<2>& mesh : {patch(3, 2), patch(6, 2), ring(3, 0.5), ring(6, 0.5)}) {
    const int nodes = mesh.nodes_per_element;
    for (int p = 0; p < mesh.num_points(); ++p) {
      const double x = mesh.point[2 * p], y = mesh.point[2 * p + 1];
      EXPECT_NEAR(value(mesh, p, linear), linear(x, y), 1e-14);
      if (nodes == 6) {
        EXPECT_NEAR(value(mesh, p, quadratic), quadratic(x, y), 1e-13);
      }
      expect_close(gradient(mesh, p, linear), Vector<2>(2, -3), 1, 1e-14, "gradient");
      if (nodes == 6)
        expect_close(gradient(mesh, p, quadratic), Vector<2>(2 * x - 2 * y + 1, 6 * y - 2 * x), 1, 1e-13,
                     "gradient");
    }
  }
}

TEST(Triangles, PointsOfARing) {
  const Discretization<2> linear = triangles(3, TRIANGLE, {0, 1, 2}, true);
  expect_close(Vector<2>(linear.point[0], linear.point[1]), Vector<2>(2. / 3, 1. / 3), 1, 1e-15, "centroid");
  const Discretization<2> quadratic =
      triangles(6, {0, 0, 2, 0, 0, 1, 1, 0.5, 0, 0.5, 1, 0}, {0, 1, 2, 3, 4, 5}, true);
  EXPECT_TRUE(quadratic.axisymmetric);
  for (int q = 0; q < 3; ++q) { // inside, nearest to vertex q
    const Vector<2> center = Vector<2>(2, 1) / 3, expected = center + (quadratic.node(q) - center) / 2;
    expect_close(Vector<2>(quadratic.point[2 * q], quadratic.point[2 * q + 1]), expected, 1, 1e-15, "point");
    EXPECT_NEAR(quadratic.weight[q], 2 * M_PI * expected[0] / 3, 1e-14);
  }
}

TEST(Triangles, QuadratureOfARing) { // of 2 pi x f over the square of side 1 at (r, 0)
  for (int nodes : {3, 6})
    for (double r : {0., 0.7}) {
      const Discretization<2> mesh = ring(nodes, r);
      const double mean = r + 0.5, mean2 = r * r + r + 1. / 3; // of x, x^2
      EXPECT_NEAR(integral(mesh, [](double, double) { return 1; }), 2 * M_PI * mean, 1e-13);
      if (nodes == 6) {
        EXPECT_NEAR(integral(mesh, [](double x, double y) { return 3 * x - y; }),
                    2 * M_PI * (3 * mean2 - mean / 2), 1e-13);
      }
    }
}

TEST(Triangles, HoopGradientOfAStretchIsExactOnTheAxisToo) { // u_r = a r: u_r/R = a
  for (int nodes : {3, 6})
    for (const Discretization<2>& mesh : {ring(nodes, 0), ring(nodes, 3)})
      for (int p = 0; p < mesh.num_points(); ++p) {
        EXPECT_GT(mesh.point[2 * p], 0);
        const double u = value(mesh, p, [](double x, double) { return 0.3 * x; });
        EXPECT_NEAR(u * mesh.inverse_radius(p), 0.3, 1e-15);
      }
}

TEST(Triangles, NodesBeyondTheAxis) {
  const Points X = {-0.1, 0, 2, 0, 0, 1}, rounded = {-1e-16, 0, 2, 0, 0, 1};
  EXPECT_NO_THROW(triangles(3, X, {0, 1, 2}));
  EXPECT_NO_THROW(triangles(3, rounded, {0, 1, 2}, true));
  expect_invalid(
      [&] {
        triangles(3, X, {0, 1, 2}, true);
      },
      "triangles: x of node 0 = -0.1, expected a radius >= 0 (axisymmetric: the axis is x = 0)");
}

TEST(Triangles, Errors) {
  const Points six = {0, 0, 2, 0, 0, 1, 1, 0.5, 0, 0.5, 1, 0};
  const auto expect = [](int nodes, const Points& X, const std::vector<int>& connectivity, const char* text) {
    expect_invalid([&] { triangles(nodes, X, connectivity); }, std::string("triangles: ") + text);
  };
  expect(4, TRIANGLE, {0, 1, 2, 2}, "nodes_per_element = 4, expected 3 (P1) or 6 (P2)");
  expect(3, {0, 0, 1}, {0, 1, 2}, "size of X = 3, expected an even number");
  expect(3, TRIANGLE, {0, 1}, "size of connectivity = 2, expected a positive multiple");
  expect(3, TRIANGLE, {}, "size of connectivity = 0, expected a positive multiple");
  expect(3, TRIANGLE, {0, 1, 3}, "node of element 0 = 3, expected 0 <= node < 3");
  expect(3, TRIANGLE, {0, 1, -1}, "node of element 0 = -1");
  expect(3, {0, 0, 2, NAN, 0, 1}, {0, 1, 2}, "X of node 1, component 1 = nan");
  expect(3, TRIANGLE, {0, 1, 2, 0, 2, 1}, "area of element 1 = -1, expected > 0");
  expect(3, {0, 0, 1, 0, 2, 0}, {0, 1, 2}, "area of element 0 = 0, expected > 0");
  expect(6, six, {0, 1, 2, 4, 3, 5}, "node 4 of element 0 is off the middle of the edge opposite vertex 0");
}
