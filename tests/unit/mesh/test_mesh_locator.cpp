// The walk from a node to the element that contains a point.
#include "iteration/predictor.hpp"
#include "support/structured_mesh.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// Field a + b x + c y + d x y of the nodes: linear part for P1, all of it for P2.
double field(const Vector<2>& x, double bilinear) { return 1 + 2 * x[0] - 3 * x[1] + bilinear * x[0] * x[1]; }

double interpolated(const Discretization<2>& d, const MeshLocator<2>& locator, int element,
                    const Vector<2>& P, double bilinear) {
  double N[6], value = 0;
  locator.shape(element, P, N);
  for (int a = 0; a < d.nodes_per_element; ++a)
    value += N[a] * field(d.node(d.element(element)[a]), bilinear);
  return value;
}

} // namespace

// From every node to every place of a ring sector: the fields that the elements carry are exact there.
TEST(MeshLocator, FindsEveryPlaceFromEveryNode) {
  for (const int order : {1, 2}) {
    const auto mesh = ring_mesh(8, 3, order, 25, 30, 0.8, 2);
    const MeshLocator<2> locator(mesh.space);
    for (int near = 0; near < mesh.space.num_nodes; near += 3)
      for (const double angle : {1.2, 1.5, 1.83})
        for (const double r : {25.6, 27.1, 29.4}) {
          const Vector<2> P = r * plane_direction(angle);
          const int element = locator.find(P, near, 0);
          ASSERT_GE(element, 0) << P.transpose() << " from node " << near;
          const double bilinear = order == 2 ? 0.3 : 0;
          EXPECT_NEAR(interpolated(mesh.space, locator, element, P, bilinear), field(P, bilinear), 1e-10);
        }
  }
}

TEST(MeshLocator, ShapeFunctionsAreOneAtTheirNodes) {
  for (const int order : {1, 2}) {
    const auto mesh = block_mesh(2, 2, order, 1, 1);
    const MeshLocator<2> locator(mesh.space);
    for (int e = 0; e < mesh.space.num_elements; ++e)
      for (int a = 0; a < mesh.space.nodes_per_element; ++a) {
        double N[6];
        locator.shape(e, mesh.space.node(mesh.space.element(e)[a]), N);
        for (int b = 0; b < mesh.space.nodes_per_element; ++b) EXPECT_NEAR(N[b], a == b, 1e-13);
      }
  }
}

// A block of cells of size 1: a place outside by less than the slack belongs to the boundary element.
TEST(MeshLocator, OutsideWithSlack) {
  const auto mesh = block_mesh(4, 3, 2, 4, 3);
  const MeshLocator<2> locator(mesh.space);
  const int near = 2; // at (2, 0)
  const Vector<2> close(2.3, 3.15), far(2.3, 3.25);
  EXPECT_EQ(locator.find(far, near), -1);
  const int element = locator.find(close, near);
  ASSERT_GE(element, 0);
  EXPECT_NEAR(interpolated(mesh.space, locator, element, close, 0.3), field(close, 0.3), 1e-12)
      << "continued beyond the side";
  EXPECT_EQ(locator.find(close, near, 0.1), -1);
  EXPECT_GE(locator.find(far, near, 0.3), 0);
  EXPECT_EQ(locator.find(Vector<2>(50, 50), near), -1);
}

// A node of no element has nothing to start from.
TEST(MeshLocator, LonelyNode) {
  const auto space = triangles(3, {0, 0, 1, 0, 0, 1, 5, 5}, {0, 1, 2});
  EXPECT_EQ(MeshLocator<2>(space).find(Vector<2>(0.2, 0.2), 3), -1);
  EXPECT_EQ(MeshLocator<2>(space).find(Vector<2>(0.2, 0.2), 1), 0);
}
