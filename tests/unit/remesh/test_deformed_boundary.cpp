// The boundary of a deformed body, divided anew: corners and labels stay, a quadratic boundary keeps its area.
#include "remesh/deformed_boundary.hpp"
#include "remesh/deformed_mesh.hpp"
#include "support/structured_mesh.hpp"
#include "unit/finite_difference.hpp"
#include <cmath>
#include <set>

using namespace burnish;
using namespace burnish::test;

namespace {

// Unit square of n x n cells; labels 1 below, 2 right, 3 above, 4 left.
Mesh<2> labelled(int n, int order) {
  Mesh<2> mesh = block_mesh(n, n, order, 1, 1).space;
  for (int e = 0; e < mesh.num_elements; ++e)
    for (int v = 0; v < 3; ++v) {
      Facet<2> facet;
      facet.vertex = {mesh.element(e)[(v + 1) % 3], mesh.element(e)[(v + 2) % 3]};
      facet.middle = {order == 2 ? mesh.element(e)[3 + v] : -1};
      facet.element = e;
      const Vector<2> m = 0.5 * (mesh.node(facet.vertex[0]) + mesh.node(facet.vertex[1]));
      const double far = 1e-9;
      facet.label = m[1] < far ? 1 : m[0] > 1 - far ? 2 : m[1] > 1 - far ? 3 : m[0] < far ? 4 : 0;
      if (facet.label > 0) mesh.facets.push_back(facet);
    }
  return mesh;
}
// The side above becomes an arc.
Eigen::VectorXd bulged(const Mesh<2>& mesh) {
  Eigen::VectorXd u = Eigen::VectorXd::Zero(mesh.num_dofs());
  for (int a = 0; a < mesh.num_nodes; ++a) {
    const Vector<2> X = mesh.node(a);
    u[2 * a + 1] = X[1] * (std::sqrt(1 - std::pow(X[0] - 0.5, 2)) - 1);
  }
  return u;
}
double area(const std::vector<OutlineEdge>& edges) {
  double sum = 0;
  for (const OutlineEdge& e : edges) sum += 0.5 * (e.from[0] * e.to[1] - e.from[1] * e.to[0]);
  return sum;
}

} // namespace

TEST(Outline, OfAnUndeformedBodyIsThatOfItsMesh) {
  const Mesh<2> mesh = labelled(5, 2);
  const auto edges = outline(mesh, Eigen::VectorXd::Zero(mesh.num_dofs()), 0);
  EXPECT_EQ(edges.size(), 20U);
  EXPECT_NEAR(area(edges), 1, 1e-12);
  std::multiset<long> labels;
  for (const OutlineEdge& edge : edges) {
    labels.insert(edge.label);
    EXPECT_NEAR((edge.to - edge.from).norm(), 0.2, 1e-12);
  }
  for (const long label : {1, 2, 3, 4}) EXPECT_EQ(labels.count(label), 5U);
}

TEST(Outline, StretchedSidesHaveMoreEdges) {
  const Mesh<2> mesh = labelled(4, 1);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(mesh.num_dofs());
  for (int a = 0; a < mesh.num_nodes; ++a)
    u[2 * a] = 2 * mesh.node(a)[0], u[2 * a + 1] = -0.5 * mesh.node(a)[1];
  EXPECT_EQ(outline(mesh, u, 0).size(), 2U * (12 + 2));
  EXPECT_EQ(outline(mesh, u, 0.5).size(), 2U * (6 + 1));
  expect_invalid([&] { outline(mesh, u, -1); }, "outline: size = -1, expected >= 0");
}

TEST(Outline, FollowsTheParabolasOfACurvedSide) {
  const int n = 6;
  const Mesh<2> mesh = labelled(n, 2);
  const Eigen::VectorXd u = bulged(mesh);
  double off = 0;
  for (const OutlineEdge& edge : outline(mesh, u, 0.03))
    if (edge.label == 3) off = std::max(off, std::abs((edge.to - Vector<2>(0.5, 0)).norm() - 1));
  // of a parabola through three places of the arc: f''' (h/2)^3/(9 sqrt 3), f''' = 3 x/(1 - x^2)^2.5 at the end x = 1/2
  const double bound = 1.5 / std::pow(0.75, 2.5) * std::pow(0.5 / n, 3) / (9 * std::sqrt(3.));
  EXPECT_LT(off, bound);
  EXPECT_GT(off, 0.1 * bound);
}

TEST(BoundaryDisplacement, KeepsTheArea) {
  const Mesh<2> mesh = labelled(6, 2);
  const Eigen::VectorXd u = bulged(mesh);
  // another mesh of the same body, vertices on the arc, straight sides
  Mesh<2> fresh = labelled(5, 2);
  for (int a = 0; a < fresh.num_nodes; ++a)
    fresh.X[2 * a + 1] *= std::sqrt(1 - std::pow(fresh.X[2 * a] - 0.5, 2));
  for (int e = 0; e < fresh.num_elements; ++e)
    for (int v = 0; v < 3; ++v)
      Eigen::Map<Vector<2>>(&fresh.X[2 * fresh.element(e)[3 + v]]) =
          0.5 * (fresh.node(fresh.element(e)[(v + 1) % 3]) + fresh.node(fresh.element(e)[(v + 2) % 3]));
  std::vector<char> fixed(fresh.num_dofs(), 0);
  const Eigen::VectorXd start = boundary_displacement<2>(mesh, u, fresh, fixed);
  const double exact = 0.25 * std::sqrt(3.) + M_PI / 6; // under the arc of radius 1 over the unit side
  const auto space = triangles(fresh);
  double straight = 0, curved = 0;
  for (int p = 0; p < space.num_points(); ++p) {
    Tensor<2> F = Tensor<2>::Identity();
    const int* node = space.element(p / 3);
    for (int a = 0; a < 6; ++a)
      F +=
          start.segment<2>(2 * node[a]) * Eigen::Map<const Vector<2>>(space.gradients(p) + 2 * a).transpose();
    straight += space.weight[p];
    curved += space.weight[p] * F.determinant();
  }
  EXPECT_GT(std::abs(straight - exact), 1e-3);
  EXPECT_LT(std::abs(curved - exact), 3e-5);
  double before = 0; // of the old body, whose boundary is that of parabolas
  for (const OutlineEdge& e : outline(mesh, u, 1e-3))
    before += 0.5 * (e.from[0] * e.to[1] - e.from[1] * e.to[0]);
  EXPECT_NEAR(curved, before, 1e-6);
  std::fill(fixed.begin(), fixed.end(), 1);
  EXPECT_TRUE(boundary_displacement<2>(mesh, u, fresh, fixed).isZero(0));
}
