// Tetrahedra: sizes, quadrature, gradients, the patch test, the stiffness against hand formulas, errors.
#include "support/kirchhoff_law.hpp"
#include "support/tetrahedra.hpp"
#include "unit/finite_difference.hpp"
#include "workpiece/workpiece.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

const double LAMBDA = 3, MU = 2;
const std::vector<double> CORNER = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};

/// Cube of side 1 at 0: 2 x 2 x 2 cells of six tetrahedra, the node in the middle (13) moved.
Discretization<3> distorted_cube(int nodes_per_element) {
  std::vector<double> X;
  std::vector<int> connectivity;
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) X.insert(X.end(), {i / 2., j / 2., k / 2.});
  X[39] = 0.58, X[40] = 0.44, X[41] = 0.53;
  const int paths[6][3] = {{1, 3, 9}, {3, 9, 1}, {9, 1, 3}, {3, 1, 9}, {9, 3, 1}, {1, 9, 3}}; // along x, y, z
  for (const int cell : {0, 1, 3, 4, 9, 10, 12, 13})
    for (int p = 0; p < 6; ++p) {
      const int a = cell + paths[p][0], b = a + paths[p][1], c = b + paths[p][2];
      connectivity.insert(connectivity.end(), {cell, p < 3 ? a : b, p < 3 ? b : a, c});
    }
  const Mesh<3> linear = linear_tetrahedra(X, connectivity);
  return tetrahedra(nodes_per_element == 4 ? linear : quadratic_tetrahedra(linear));
}

Vector<3> point(const Discretization<3>& mesh, int p) {
  return Eigen::Map<const Vector<3>>(mesh.point.data() + 3 * p);
}

template <class Function> double integral(const Discretization<3>& mesh, const Function& f) {
  double sum = 0;
  for (int p = 0; p < mesh.num_points(); ++p) sum += mesh.weight[p] * f(point(mesh, p));
  return sum;
}

/// Value and gradient at a point of the interpolation of f.
template <class Function>
std::pair<double, Vector<3>> interpolated(const Discretization<3>& mesh, int p, const Function& f) {
  double value = 0;
  Vector<3> gradient = Vector<3>::Zero();
  const int* node = mesh.element(p / mesh.points_per_element);
  for (int a = 0; a < mesh.nodes_per_element; ++a) {
    value += mesh.shapes(p)[a] * f(mesh.node(node[a]));
    gradient += f(mesh.node(node[a])) * Eigen::Map<const Vector<3>>(mesh.gradients(p) + 3 * a);
  }
  return {value, gradient};
}

Eigen::MatrixXd stiffness(const Discretization<3>& mesh) {
  const Workpiece<3> body(mesh, std::make_shared<KirchhoffLaw>(LAMBDA, MU));
  NodeBlockMatrix<3> K = body.pattern();
  body.tangent(K, TangentKind::CONSISTENT);
  Eigen::MatrixXd dense(K.size(), K.size());
  for (int c = 0; c < K.size(); ++c) dense.col(c) = K.multiply(Eigen::VectorXd::Unit(K.size(), c));
  return dense;
}

/// Stiffness of one undeformed element of constant moduli: sum over m of the integrals of grad N_a = sum over i of
/// l_i G_ai, of l_i l_j = V (1 + delta_ij)/20, with the gradients g_i of the barycentric coordinates l_i.
Eigen::MatrixXd by_hand(const Discretization<3>& mesh) {
  const int nodes = mesh.nodes_per_element;
  Tensor<3> edges;
  for (int v = 1; v < 4; ++v) edges.col(v - 1) = mesh.node(v) - mesh.node(0);
  const double volume = edges.determinant() / 6;
  Eigen::Matrix<double, 4, 3> g;
  g.bottomRows<3>() = edges.inverse();
  g.row(0) = -g.bottomRows<3>().colwise().sum();
  std::vector<Eigen::Matrix<double, 4, 3>> G(nodes); // row i: factor of l_i
  for (int a = 0; a < nodes; ++a)
    for (int i = 0; i < 4; ++i) {
      if (nodes == 4) G[a].row(i) = g.row(a);
      if (nodes == 10 && a < 4) G[a].row(i) = (4 * (i == a) - 1) * g.row(a);
      if (nodes == 10 && a >= 4) {
        const auto [b, c] = SimplexEdges<3>::ends[a - 4];
        G[a].row(i) = 4 * ((i == b) * g.row(c) + (i == c) * g.row(b));
      }
    }
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(3 * nodes, 3 * nodes);
  for (int a = 0; a < nodes; ++a)
    for (int b = 0; b < nodes; ++b)
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
          const Vector<3> p = G[a].row(i), q = G[b].row(j);
          const Tensor<3> pq = p * q.transpose(), qp = q * p.transpose();
          K.block<3, 3>(3 * a, 3 * b) +=
              volume * (1 + (i == j)) / 20. * (LAMBDA * pq + MU * qp + MU * p.dot(q) * Tensor<3>::Identity());
        }
  return K;
}

} // namespace

TEST(Tetrahedra, Sizes) {
  for (const int nodes : {4, 10}) {
    const Discretization<3> mesh = distorted_cube(nodes);
    EXPECT_EQ(mesh.num_elements, 48);
    EXPECT_EQ(mesh.num_nodes, nodes == 4 ? 27 : 125);
    EXPECT_EQ(mesh.points_per_element, nodes == 4 ? 1 : 4);
    EXPECT_EQ(mesh.weight.size(), std::size_t(mesh.num_points()));
    EXPECT_EQ(mesh.point.size(), std::size_t(3 * mesh.num_points()));
    EXPECT_EQ(mesh.shape.size(), std::size_t(nodes * mesh.points_per_element));
    EXPECT_EQ(mesh.shape_grad.size(), std::size_t(3 * nodes * mesh.num_points()));
  }
}

TEST(Tetrahedra, PointsOfFreeFem) {
  const Mesh<3> corner = linear_tetrahedra(CORNER, {0, 1, 2, 3});
  const Discretization<3> linear = tetrahedra(corner), quadratic = tetrahedra(quadratic_tetrahedra(corner));
  expect_close(point(linear, 0), Vector<3>(0.25, 0.25, 0.25), 1, 1e-15, "centroid");
  EXPECT_DOUBLE_EQ(linear.weight[0], 1. / 6);
  const double near = 0.5854101966249684, far = 0.1381966011250105;
  for (int q = 0; q < 4; ++q) {
    const Vector<3> expected(q == 0 ? near : far, q == 1 ? near : far, q == 2 ? near : far);
    expect_close(point(quadratic, q), expected, 1, 2e-16, "point");
    EXPECT_DOUBLE_EQ(quadratic.weight[q], 1. / 24);
  }
}

TEST(Tetrahedra, QuadratureIsExactToItsDegree) {
  for (const int nodes : {4, 10}) {
    const Discretization<3> mesh = distorted_cube(nodes);
    EXPECT_NEAR(integral(mesh, [](const Vector<3>&) { return 1; }), 1, 1e-14);
    EXPECT_NEAR(integral(mesh, [](const Vector<3>& x) { return 3 * x[0] - x[1] + 2 * x[2]; }), 2, 1e-14);
    const double second = integral(mesh, [](const Vector<3>& x) { return x[0] * x[0] + x[1] * x[2]; });
    if (nodes == 10) {
      EXPECT_NEAR(second, 1. / 3 + 1. / 4, 1e-14);
    } else {
      EXPECT_GT(std::abs(second - 1. / 3 - 1. / 4), 1e-3);
    }
  }
}

TEST(Tetrahedra, ShapesAndGradientsReproduceTheirPolynomials) {
  const auto linear = [](const Vector<3>& x) { return 2 * x[0] - 3 * x[1] + x[2] + 1; };
  const auto quadratic = [](const Vector<3>& x) { return x[0] * x[0] - 2 * x[0] * x[1] + 3 * x[1] * x[2]; };
  for (const int nodes : {4, 10}) {
    const Discretization<3> mesh = distorted_cube(nodes);
    for (int p = 0; p < mesh.num_points(); ++p) {
      const Vector<3> x = point(mesh, p);
      EXPECT_NEAR(interpolated(mesh, p, linear).first, linear(x), 1e-14);
      expect_close(interpolated(mesh, p, linear).second, Vector<3>(2, -3, 1), 1, 2e-14, "gradient");
      if (nodes == 4) continue;
      EXPECT_NEAR(interpolated(mesh, p, quadratic).first, quadratic(x), 1e-14);
      expect_close(interpolated(mesh, p, quadratic).second,
                   Vector<3>(2 * x[0] - 2 * x[1], 3 * x[2] - 2 * x[0], 3 * x[1]), 1, 2e-14, "gradient");
    }
  }
}

// Uniform strain at every point; nodes inside are in equilibrium, of the finite forces and of the linear stiffness.
TEST(Tetrahedra, PatchTest) {
  const Tensor<3> H = (Tensor<3>() << 0.03, 0.1, -0.02, 0.04, -0.05, 0.06, 0.01, -0.03, 0.08).finished();
  for (const int nodes : {4, 10}) {
    const Discretization<3> mesh = distorted_cube(nodes);
    Workpiece<3> body(mesh, std::make_shared<KirchhoffLaw>(LAMBDA, MU));
    Eigen::VectorXd u(mesh.num_dofs());
    std::vector<int> inside;
    for (int a = 0; a < mesh.num_nodes; ++a) {
      const Vector<3> x = mesh.node(a);
      u.segment<3>(3 * a) = H * x;
      if (x.minCoeff() > 1e-9 && x.maxCoeff() < 1 - 1e-9) inside.push_back(a);
    }
    ASSERT_EQ(inside.size(), nodes == 4 ? 1u : 27u);
    ASSERT_EQ(body.update(u, 1, 0).status, UpdateStatus::OK);
    const Tensor<3> F = Tensor<3>::Identity() + H;
    for (int p = 0; p < mesh.num_points(); ++p)
      expect_close(mesh_part<3>(point_state(body.state(), p).F), F, 1, 2e-15, "F");
    const Eigen::VectorXd force = body.internal_force(), exact = stiffness(mesh) * u;
    for (const int a : inside) {
      EXPECT_LE(force.segment<3>(3 * a).norm(), 1e-14 * force.norm()) << "node " << a;
      EXPECT_LE(exact.segment<3>(3 * a).norm(), 1e-14 * exact.norm()) << "node " << a;
    }
  }
}

TEST(Tetrahedra, StiffnessByHand) {
  const Mesh<3> skew =
      linear_tetrahedra({0.1, 0.2, 0, 1.3, 0.1, -0.2, 0.4, 0.9, 0.3, 0.2, -0.1, 0.8}, {0, 1, 2, 3});
  for (const Discretization<3>& mesh : {tetrahedra(skew), tetrahedra(quadratic_tetrahedra(skew))}) {
    const Eigen::MatrixXd expected = by_hand(mesh);
    EXPECT_LE((stiffness(mesh) - expected).norm(), 2e-15 * expected.norm()) << mesh.nodes_per_element;
  }
}

TEST(Tetrahedra, Errors) {
  const auto expect = [](const Mesh<3>& mesh, const char* text) {
    expect_invalid([&] { tetrahedra(mesh); }, std::string("tetrahedra: ") + text);
  };
  const Mesh<3> good = linear_tetrahedra(CORNER, {0, 1, 2, 3});
  expect(linear_tetrahedra(CORNER, {0, 1, 2, 3, 0, 2, 1, 3}),
         "volume of element 1 at (0.25, 0.25, 0.25) = -0.166667, expected > 0 (seen from vertex 3 the others "
         "are");
  expect(linear_tetrahedra({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, {0, 1, 2, 3}),
         "volume of element 0 at (0.5, 0.5, 0) = 0, expected > 0");
  const std::string one = "volume of element 0 at (0.25, 0.25, 0.25) = -0.166667, expected > 0 (seen from "
                          "vertex 3 the others are counter-clockwise)";
  expect(linear_tetrahedra(CORNER, {0, 2, 1, 3, 0, 2, 1, 3}), // mirrored as a whole
         (one + "; 2 of 2 elements are negative: the map of the mesh mirrors it").c_str());
  expect(linear_tetrahedra(CORNER, {0, 1, 2, 4}), "node of element 0 = 4, expected 0 <= node < 4");
  Mesh<3> wrong = good;
  wrong.nodes_per_element = 5;
  expect(wrong, "nodes_per_element = 5, expected 4 (P1) or 10 (P2)");
  wrong = good;
  wrong.axisymmetric = true;
  expect(wrong, "axisymmetric = 1, expected 0");
  Mesh<3> bent = quadratic_tetrahedra(good);
  bent.X[3 * 5 + 2] += 0.01; // the middle of the edge from 0 to 2
  expect(bent, "node 5 of element 0 is off the middle of the edge from vertex 0 to 2 by 0.01 of its length");
}
