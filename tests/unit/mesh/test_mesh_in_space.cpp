// What a mesh of tetrahedra has: validity, facets by label, their nodes, the element of a place.
#include "mesh/mesh_locator.hpp"
#include "support/tetrahedra.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// With two facets: 0 1 2 of the first element, label 7; 1 2 4 of the second, label 8.
Discretization<3> labeled() {
  Discretization<3> mesh = two_tetrahedra(10);
  // mid-edge nodes 01 02 03 12 13 23 of an element follow its four vertices
  const int *first = mesh.element(0) + 4, *second = mesh.element(1) + 4;
  mesh.facets = {{{0, 1, 2}, {first[3], first[1], first[0]}, 0, 7},
                 {{1, 2, 4}, {second[4], second[2], second[0]}, 1, 8}};
  return mesh;
}

} // namespace

TEST(MeshInSpace, FacetsOppositeToVertices) {
  const Discretization<3> mesh = two_tetrahedra(10);
  const int* nodes = mesh.element(1);
  for (int f = 0; f < 4; ++f) {
    const Facet<3> facet = facet_opposite<3>(nodes, true, f);
    const Vector<3> a = mesh.node(facet.vertex[0]), b = mesh.node(facet.vertex[1]),
                    c = mesh.node(facet.vertex[2]);
    EXPECT_GT((b - a).cross(c - a).dot(a - mesh.node(nodes[f])), 0)
        << "counter-clockwise from outside, " << f;
    for (int e = 0; e < 3; ++e) {
      const auto [i, j] = SimplexEdges<2>::ends[e];
      const Vector<3> middle = 0.5 * (mesh.node(facet.vertex[i]) + mesh.node(facet.vertex[j]));
      EXPECT_LE((mesh.node(facet.middle[e]) - middle).norm(), 1e-15);
    }
    EXPECT_EQ(facet_opposite<3>(nodes, false, f).middle, (std::array<int, 3>{-1, -1, -1}));
  }
  const int triangle[] = {5, 6, 7, 8, 9, 10};
  const Facet<2> edge = facet_opposite<2>(triangle, true, 1);
  EXPECT_EQ(edge.vertex, (std::array<int, 2>{7, 5})) << "the body is on the left";
  EXPECT_EQ(edge.middle[0], 9);
}

TEST(MeshInSpace, FacetsAndTheirNodes) {
  const Discretization<3> mesh = labeled();
  EXPECT_NO_THROW(require_valid<3>(mesh, "here"));
  const auto facets = facets_with<3>(mesh, {7, 8}, "here");
  ASSERT_EQ(facets.size(), 2u);
  EXPECT_EQ(facets[1].element, 1);
  const std::vector<int> nodes = nodes_along<3>(facets);
  EXPECT_EQ(nodes.size(), 9u) << "twelve, of which the edge 1 2 has three in common";
  for (const auto& facet : facets)
    for (int e = 0; e < 3; ++e) { // each mid node is in the middle of its edge
      const auto [a, b] = SimplexEdges<2>::ends[e];
      const Vector<3> middle = 0.5 * (mesh.node(facet.vertex[a]) + mesh.node(facet.vertex[b]));
      EXPECT_LE((mesh.node(facet.middle[e]) - middle).norm(), 1e-15);
    }
  expect_invalid([&] { facets_with<3>(mesh, {9}, "here"); }, "here: no boundary face bears the label 9");
  Discretization<3> wrong = mesh;
  wrong.connectivity[3] = 99;
  expect_invalid([&] { require_valid<3>(wrong, "here"); }, "here: node of element 0 = 99");
}

TEST(MeshInSpace, ElementOfAPlace) {
  const Discretization<3> mesh = two_tetrahedra(4);
  const MeshLocator<3> locator(mesh);
  for (int e : {0, 1}) {
    const Vector<3> at = Eigen::Map<const Vector<3>>(mesh.point.data() + 3 * e);
    for (int near = 0; near < mesh.num_nodes; ++near) EXPECT_EQ(locator.find(at, near), e);
    double N[4];
    locator.shape(e, at, N);
    for (const double n : N) EXPECT_NEAR(n, 0.25, 1e-15);
  }
  EXPECT_EQ(locator.find(Vector<3>(-9, 0, 0), 0), -1);
}

// Linear parts of a quadratic triangle and segment: each as large as the others, none turned over, all of it together.
TEST(Simplex, LinearPartsFillTheQuadraticOne) {
  Eigen::Matrix<double, 6, 3> nodes = Eigen::Matrix<double, 6, 3>::Zero();
  nodes.topRows<3>().setIdentity();
  for (int e = 0; e < 3; ++e)
    for (const int end : SimplexEdges<2>::ends[e]) nodes(3 + e, end) += 0.5;
  ASSERT_EQ(linear_parts<2>(6).size(), 4u);
  for (const auto& [a, b, c] : linear_parts<2>(6)) {
    Eigen::Matrix3d corners;
    corners << nodes.row(a), nodes.row(b), nodes.row(c);
    EXPECT_NEAR(corners.determinant(), 0.25, 1e-15) << a << b << c;
  }
  EXPECT_EQ(linear_parts<2>(3), (std::vector<std::array<int, 3>>{{0, 1, 2}}));
  EXPECT_EQ(linear_parts<1>(3), (std::vector<std::array<int, 2>>{{0, 2}, {2, 1}}));
  EXPECT_EQ(linear_parts<1>(2), (std::vector<std::array<int, 2>>{{0, 1}}));
}
