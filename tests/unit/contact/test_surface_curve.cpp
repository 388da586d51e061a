// Mid nodes of the contact surface on the curve through its vertices.
#include "contact/surface_curve.hpp"
#include <cmath>
#include <gtest/gtest.h>

using namespace burnish;

namespace {

// Edges between vertices 0, 1, ... in a row, the mid node of edge e is n + 1 + e; no elements.
struct Chain {
  Mesh<2> mesh;
  std::vector<Facet<2>> surface;
  explicit Chain(const std::vector<Vector<2>>& vertices) {
    const int n = static_cast<int>(vertices.size()) - 1;
    for (const auto& x : vertices) add(x);
    for (int e = 0; e < n; ++e) {
      add(0.5 * (vertices[e] + vertices[e + 1]));
      surface.push_back({{e, e + 1}, {n + 1 + e}});
    }
  }
  void add(const Vector<2>& x) {
    mesh.X.insert(mesh.X.end(), {x[0], x[1]});
    ++mesh.num_nodes;
  }
  Vector<2> mid(const Eigen::VectorXd& X, int e) const { return X.segment<2>(2 * surface[e].middle[0]); }
};

// Largest distance from the ellipse of half axes 3, 2 with n vertices.
double off_ellipse(int n) {
  std::vector<Vector<2>> vertices;
  for (int i = 0; i <= n; ++i) {
    const double angle = 2 * M_PI * i / n;
    vertices.emplace_back(3 * std::cos(angle), 2 * std::sin(angle));
  }
  const Chain chain(vertices);
  const Eigen::VectorXd X = places_on_curve(chain.mesh, chain.surface);
  double off = 0;
  for (int e = 1; e + 1 < n; ++e) {
    const Vector<2> x = chain.mid(X, e);
    off = std::max(off, std::abs(std::hypot(x[0] / 3, x[1] / 2) - 1));
  }
  return off;
}

} // namespace

TEST(SurfaceCurve, MidNodesOfACircleLieOnIt) {
  for (const double side : {1., -1.}) { // around the body, and around a hole
    std::vector<Vector<2>> vertices;
    for (const double angle : {0.1, 0.3, 0.4, 0.7, 0.9, 1.3})
      vertices.emplace_back(5 * std::cos(angle), side * 5 * std::sin(angle));
    const Chain chain(vertices);
    const Eigen::VectorXd X = places_on_curve(chain.mesh, chain.surface);
    for (int e = 0; e < 5; ++e) EXPECT_NEAR(chain.mid(X, e).norm(), 5, 1e-12);
  }
}

TEST(SurfaceCurve, OrderOnAnEllipse) {
  const double coarse = off_ellipse(40), fine = off_ellipse(80);
  EXPECT_LT(coarse, 1e-4); // the chords are 3e-3 off
  EXPECT_GT(std::log2(coarse / fine), 3.7);
}

TEST(SurfaceCurve, LinesAndCornersStay) {
  const Chain chain({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 3}});
  const Eigen::VectorXd X = places_on_curve(chain.mesh, chain.surface);
  for (Eigen::Index d = 0; d < X.size(); ++d) EXPECT_EQ(X[d], chain.mesh.X[static_cast<std::size_t>(d)]);
}

TEST(SurfaceCurve, LineIntoArc) { // the last edge of the line stays straight, the arc's second one is exact
  std::vector<Vector<2>> vertices{{-2, 0}, {-1, 0}};
  for (int i = 0; i < 5; ++i) vertices.emplace_back(4 * std::sin(0.2 * i), 4 - 4 * std::cos(0.2 * i));
  const Chain chain(vertices);
  const Eigen::VectorXd X = places_on_curve(chain.mesh, chain.surface);
  EXPECT_EQ(chain.mid(X, 0)[1], 0);
  EXPECT_LT(std::abs(chain.mid(X, 1)[1]), 0.01); // of 1 between a line and a radius of 4
  EXPECT_NEAR((chain.mid(X, 3) - Vector<2>(0, 4)).norm(), 4, 1e-12);
}

TEST(SurfaceCurve, PlacesOfTheScript) {
  const Chain chain({{0, 0}, {1, 0}, {2, 0}});
  Eigen::VectorXd places = Eigen::Map<const Eigen::VectorXd>(chain.mesh.X.data(), chain.mesh.num_dofs());
  places[2 * 3 + 1] = -0.1; // middle of the first edge
  places[0] = 7;            // of a vertex: does not count
  const Eigen::VectorXd X = places_given(chain.mesh, chain.surface, places);
  EXPECT_EQ(X[2 * 3 + 1], -0.1);
  EXPECT_EQ(X[0], 0);
  places[2 * 3 + 1] = -0.3;
  EXPECT_THROW(places_given(chain.mesh, chain.surface, places), std::invalid_argument);
  places[2 * 3 + 1] = std::nan("");
  EXPECT_THROW(places_given(chain.mesh, chain.surface, places), std::invalid_argument);
  EXPECT_THROW(places_given(chain.mesh, chain.surface, Eigen::VectorXd(places.head(4))),
               std::invalid_argument);
}
