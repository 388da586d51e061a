// A deformed body of tetrahedra meshed anew: its surface in patches, labels and sharp edges kept, vertices and mid nodes on the
// quadratic surface, volume kept.
#include "remesh/patch_lines.hpp"
#include "remesh/volume_mesh.hpp"
#include "support/tetrahedra.hpp"
#include "unit/finite_difference.hpp"
#include <cmath>
#include <map>
#include <set>

using namespace burnish;
using namespace burnish::test;

namespace {

// Unit cube; label 1 above.
Mesh<3> cube(int n, int nodes_per_element) {
  const std::vector<double> even = divisions(0, 1, 1. / n);
  return block_of_tetrahedra(even, even, even, nodes_per_element);
}
// Its sides become wider in the middle, as those of a block between plates.
Eigen::VectorXd bulged(const Mesh<3>& mesh) {
  Eigen::VectorXd u = Eigen::VectorXd::Zero(mesh.num_dofs());
  for (int a = 0; a < mesh.num_nodes; ++a) {
    const Vector<3> X = mesh.node(a);
    const double wider = 0.3 * 4 * X[2] * (1 - X[2]);
    u[3 * a] = wider * (X[0] - 0.5);
    u[3 * a + 1] = wider * (X[1] - 0.5);
  }
  return u;
}
const double BULGED = 1 + 2 * 0.3 * 2. / 3 + 0.09 * 8. / 15; // volume: the sides are 1 + 1.2 z (1 - z) long

// Cube to ball.
Mesh<3> ball(int n) {
  return block_of_tetrahedra(n, n, n, [](double x, double y, double z) {
    const Vector<3> c = 2 * Vector<3>(x, y, z) - Vector<3>::Ones();
    const double far = c.norm();
    return Vector<3>(far > 0 ? Vector<3>(c / far * c.cwiseAbs().maxCoeff()) : c);
  });
}
Mesh<3> mesh_of(const VolumeMesh& from) {
  std::vector<double> X;
  std::vector<int> connectivity;
  for (const Vector<3>& x : from.node) X.insert(X.end(), x.begin(), x.end());
  for (const auto& element : from.tetrahedron)
    connectivity.insert(connectivity.end(), element.begin(), element.end());
  return linear_tetrahedra(std::move(X), std::move(connectivity));
}
std::set<std::set<int>> faces_of(const Mesh<3>& mesh) {
  std::set<std::set<int>> faces;
  for (const BoundaryFace& face : boundary_faces(mesh, Eigen::VectorXd::Zero(mesh.num_dofs())))
    faces.emplace(face.facet.vertex.begin(), face.facet.vertex.end());
  return faces;
}

} // namespace

TEST(DeformedSurface, EndsPatchesAtEdgesAndLabels) {
  const Mesh<3> mesh = cube(3, 10);
  const DeformedSurface surface(mesh, bulged(mesh));
  EXPECT_EQ(surface.faces().size(), 6U * 9 * 2);
  EXPECT_EQ(surface.num_patches(), 6);
  EXPECT_NEAR(surface.volume(), BULGED, 1e-12); // a quadratic surface
  std::multiset<long> labels;
  for (int p = 0; p < surface.num_patches(); ++p) labels.insert(surface.label(p));
  EXPECT_EQ(labels.count(1), 1U);
  EXPECT_EQ(labels.count(0), 5U);
  EXPECT_EQ(surface.nearest_patch({0.5, 0.5, 0.9}, 7), -1);
}

TEST(DeformedSurface, CutsAClosedOneInTwo) {
  const Mesh<3> mesh = ball(10);
  const DeformedSurface surface(mesh, Eigen::VectorXd::Zero(mesh.num_dofs()));
  EXPECT_EQ(surface.num_patches(), 2);
  EXPECT_NEAR(surface.volume(), 4. / 3 * M_PI, 0.03 * 4);
}

TEST(DeformedSurface, FindsPlacesOnPatchesAndWhereTheyMeet) {
  const Mesh<3> mesh = cube(4, 10);
  const DeformedSurface surface(mesh, bulged(mesh));
  const auto beyond = [](double z) { return 0.5 + 0.5 * (1 + 1.2 * z * (1 - z)); }; // of the side x > 1/2
  const Vector<3> side(1.2, 0.6, 0.37);
  const int patch = surface.nearest_patch(side, 0);
  const auto [foot, squared] = surface.nearest(side, patch);
  EXPECT_NEAR(foot[0], beyond(foot[2]), 1e-12);
  EXPECT_NEAR(squared, (foot - side).squaredNorm(), 1e-14);
  const double slope = 0.6 * (1 - 2 * foot[2]); // at the foot the way is normal to the side
  EXPECT_NEAR((side - foot).dot(Vector<3>(slope, 0, 1)), 0, 1e-10);
  const int other = surface.nearest_patch({0.6, 1.2, 0.37}, 0);
  ASSERT_NE(other, patch);
  const Vector<3> corner = surface.common_place({1.13, 1.1, 0.37}, {patch, other});
  EXPECT_NEAR(corner[0], beyond(corner[2]), 1e-10);
  EXPECT_NEAR(corner[1], beyond(corner[2]), 1e-10);
}

TEST(PatchLines, RunFromCornerToCorner) {
  Mesh<3> mesh = cube(4, 10);
  for (Facet<3>& facet : mesh.facets) { // of those above a square in the middle has another label
    Vector<3> middle = Vector<3>::Zero();
    for (const int v : facet.vertex) middle += mesh.node(v) / 3;
    if ((middle - Vector<3>(0.5, 0.5, 1)).cwiseAbs().maxCoeff() < 0.25) facet.label = 2;
  }
  const DeformedSurface surface(mesh, bulged(mesh));
  EXPECT_EQ(surface.num_patches(), 7);
  int edges = 0, square = 0;
  for (const PatchLine& line : patch_lines(surface)) {
    const bool inner = surface.label(line.patches[0]) + surface.label(line.patches[1]) == 3;
    (inner ? square : edges) += 1;
    EXPECT_EQ(line.nodes.size(), inner ? 5U : 9U); // 2 or 4 quadratic edges
    EXPECT_NE(line.nodes.front(), line.nodes.back());
  }
  EXPECT_EQ(edges, 12);
  EXPECT_EQ(square, 4);
}

TEST(PatchLines, MayBeClosed) {
  // a smooth pillow: its sides are one patch, below and above another label
  Mesh<3> mesh = ball(12);
  for (const BoundaryFace& face : boundary_faces(mesh, Eigen::VectorXd::Zero(mesh.num_dofs()))) {
    Facet<3> facet = face.facet;
    const double z = (face.x[0] + face.x[1] + face.x[2])[2] / 3;
    facet.label = z > 0.9 ? 2 : 1;
    mesh.facets.push_back(facet);
  }
  const DeformedSurface surface(mesh, Eigen::VectorXd::Zero(mesh.num_dofs()));
  EXPECT_EQ(surface.num_patches(), 2);
  const std::vector<PatchLine> lines = patch_lines(surface);
  std::map<int, int> ends; // every corner is the end of two
  for (const PatchLine& line : lines) {
    ++ends[line.nodes.front()];
    ++ends[line.nodes.back()];
  }
  for (const auto& [corner, number] : ends) EXPECT_EQ(number, 2);
}

TEST(VolumeMesh, KeepsLabelsEdgesAndVolume) {
  const Mesh<3> mesh = cube(4, 10);
  const Eigen::VectorXd u = bulged(mesh);
  const VolumeMesh fresh = volume_mesh(mesh, u);
  const Mesh<3> linear = mesh_of(fresh);
  require_valid(linear, "test"); // none is inverted
  std::set<std::set<int>> listed;
  for (const auto& face : fresh.face) listed.emplace(face.begin(), face.end());
  EXPECT_EQ(listed, faces_of(linear));
  EXPECT_NEAR(static_cast<double>(fresh.tetrahedron.size()), BULGED * mesh.num_elements,
              0.15 * BULGED * mesh.num_elements);
  double above = 0;
  for (std::size_t f = 0; f < fresh.face.size(); ++f) {
    const auto& [a, b, c] = fresh.face[f];
    if (fresh.label[f] != 1) continue;
    above += 0.5 * (fresh.node[b] - fresh.node[a]).cross(fresh.node[c] - fresh.node[a])[2];
    for (const int node : fresh.face[f]) EXPECT_NEAR(fresh.node[node][2], 1, 1e-12);
  }
  EXPECT_NEAR(above, 1, 1e-12);
  Mesh<3> quadratic = quadratic_tetrahedra(linear);
  for (std::size_t f = 0; f < fresh.face.size(); ++f)
    quadratic.facets.push_back({fresh.face[f], {}, -1, fresh.label[f]});
  const Eigen::VectorXd start = surface_displacement(mesh, u, quadratic);
  const DeformedSurface straight(quadratic, Eigen::VectorXd::Zero(start.size())), curved(quadratic, start);
  EXPECT_GT(std::abs(straight.volume() / BULGED - 1), 1e-3);
  EXPECT_NEAR(curved.volume(), BULGED, 1e-4 * BULGED);
  for (const BoundaryFace& face : curved.faces())
    for (const Vector<3>& x : face.x) {
      const double far = 0.5 * (1 + 1.2 * x[2] * (1 - x[2])); // of a side
      const double side = std::max(std::abs(x[0] - 0.5), std::abs(x[1] - 0.5));
      if (x[2] <= 1e-9 || x[2] >= 1 - 1e-9) continue;
      EXPECT_NEAR(side, far, 5e-4);
    }
}

TEST(VolumeMesh, OfABallIsTheSameEachTime) {
  const Mesh<3> mesh = ball(8);
  const Eigen::VectorXd u = Eigen::VectorXd::Zero(mesh.num_dofs());
  const double volume = DeformedSurface(mesh, u).volume();
  const VolumeMesh one = volume_mesh(mesh, u);
  const std::vector<double> between(12345, 1.); // moves what is allocated next
  const VolumeMesh other = volume_mesh(mesh, u);
  EXPECT_EQ(one.node, other.node);
  EXPECT_EQ(one.tetrahedron, other.tetrahedron);
  const Mesh<3> fresh = mesh_of(one);
  require_valid(fresh, "test");
  EXPECT_NEAR(DeformedSurface(fresh, Eigen::VectorXd::Zero(fresh.num_dofs())).volume(), volume,
              0.02 * volume);
}

TEST(VolumeMesh, TakesLengthsOfEdges) {
  const Mesh<3> mesh = cube(3, 10);
  const Eigen::VectorXd u = Eigen::VectorXd::Zero(mesh.num_dofs());
  const auto count = [&](double size) {
    return static_cast<double>(
        volume_mesh(mesh, u, CornerSizes::Constant(4, mesh.num_elements, size)).tetrahedron.size());
  };
  EXPECT_NEAR(count(0.1) / count(0.2), 8, 3);
  expect_invalid([&] { count(0); }, "a new mesh: length of edges = 0, expected > 0");
  expect_invalid([&] { count(1e-3); }, "number of tetrahedra that the lengths of edges make");
}

TEST(VolumeMesh, RefusesABodyThatGoesThroughItself) {
  const Mesh<3> mesh = cube(4, 10);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(mesh.num_dofs());
  for (int a = 0; a < mesh.num_nodes; ++a) { // the middle of the top comes out below
    const Vector<3> X = mesh.node(a);
    if (X[2] > 1 - 1e-9 && (X - Vector<3>(0.5, 0.5, 1)).norm() < 0.3) u[3 * a + 2] = -1.5;
  }
  expect_invalid([&] { volume_mesh(mesh, u, CornerSizes::Constant(4, mesh.num_elements, 0.25)); },
                 "a new mesh: gmsh failed on the deformed workpiece");
}

// Two pyramids on the top meet in a vertex: the flat patch around them touches itself there.
TEST(VolumeMesh, JoinsPatchesThatGmshCannotParametrize) {
  const Mesh<3> mesh = cube(8, 10);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(mesh.num_dofs());
  for (int a = 0; a < mesh.num_nodes; ++a) {
    const Vector<3> X = mesh.node(a);
    for (const double middle : {0.375, 0.625}) {
      const double way = 0.125 - std::max(std::abs(X[0] - middle), std::abs(X[1] - middle));
      if (X[2] > 1 - 1e-9) u[3 * a + 2] += 0.42 * std::max(0., way);
    }
  }
  EXPECT_GT(DeformedSurface(mesh, u).num_patches(), 7);
  EXPECT_EQ(DeformedSurface(mesh, u, 0.6).num_patches(), 6);
  const VolumeMesh fresh = volume_mesh(mesh, u, CornerSizes::Constant(4, mesh.num_elements, 0.12));
  const Mesh<3> linear = mesh_of(fresh);
  require_valid(linear, "test");
  const double volume = DeformedSurface(mesh, u).volume();
  EXPECT_NEAR(DeformedSurface(linear, Eigen::VectorXd::Zero(linear.num_dofs())).volume(), volume,
              5e-3 * volume);
}
