// Triangles of surfaces: on the surface, oriented, no further from it than promised, whole.
#include "geometry/polygon.hpp"
#include "kinematics/cartesian_in_space.hpp"
#include "kinematics/surface_mesh.hpp"
#include "unit/finite_difference.hpp"
#include "unit/geometry/surface_samples.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

const Param<3> ANY(0, 0);
const Eigen::AlignedBox3d WINDOW(Vector<3>(-3, -2, -1), Vector<3>(3, 2, 4));

Vector<3> area_of(const SurfaceMesh& mesh, const std::array<int, 3>& t) {
  const auto at = [&](int i) {
    return mesh.points[static_cast<std::size_t>(t[static_cast<std::size_t>(i)])];
  };
  return (at(1) - at(0)).cross(at(2) - at(0)) / 2;
}
double area(const SurfaceMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) sum += area_of(mesh, t).norm();
  return sum;
}
/// Of the space around the origin that a closed surface encloses.
double volume(const SurfaceMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles)
    sum += area_of(mesh, t).dot(mesh.points[static_cast<std::size_t>(t[0])]) / 3;
  return sum;
}

} // namespace

TEST(SurfaceMesh, LiesOnTheSurface) {
  const double allowed = MESH_SAGITTA * WINDOW.sizes().maxCoeff();
  for (const auto& [name, surface] : surfaces(skew_axis())) {
    SCOPED_TRACE(name);
    const SurfaceMesh mesh = surface_mesh(*surface, WINDOW);
    ASSERT_GE(mesh.triangles.size(), 2u);
    EXPECT_LT(mesh.points.size(), 60000u);
    for (const auto& point : mesh.points) ASSERT_NEAR(surface->foot(point, ANY).gap, 0, 1e-12);
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 7) {
      Vector<3> middle = Vector<3>::Zero();
      for (const int corner : mesh.triangles[i]) middle += mesh.points[static_cast<std::size_t>(corner)] / 3;
      const auto foot = surface->foot(middle, ANY);
      ASSERT_LE(std::abs(foot.gap), 1.001 * allowed);
      ASSERT_GT(area_of(mesh, mesh.triangles[i]).dot(surface->frame(foot.place).n), 0) << "towards the body";
    }
  }
}

TEST(SurfaceMesh, RoundHoweverSmallInTheWindow) {
  const double R = 4e-3, r = 1e-3; // of a window that is 6 long
  EXPECT_NEAR(volume(surface_mesh(*torus(R, r), WINDOW)) / (2 * M_PI * M_PI * R * r * r), 1, 0.01);
}

TEST(SurfaceMesh, AreasAndVolumes) {
  const auto mesh_of = [](const Surface<3>& surface) {
    return surface_mesh(surface, {Vector<3>(-2, -2, -2), Vector<3>(2, 2, 2)});
  };
  const SurfaceMesh ball = mesh_of(*sphere(2));
  EXPECT_NEAR(area(ball) / (16 * M_PI), 1, 3e-3);
  EXPECT_NEAR(volume(ball) / (32 * M_PI / 3), 1, 3e-3);
  EXPECT_NEAR(volume(mesh_of(*torus(3, 1))) / (6 * M_PI * M_PI), 1, 6e-3);
  EXPECT_NEAR(volume(mesh_of(*torus(3, 1, {}, true))) / (-6 * M_PI * M_PI), 1, 6e-3) << "the body is within";
  // Steiner: inner box, slabs on its sides, quarter cylinders, a ball
  const double r = 0.4, a = 3.2, b = 2.2, c = 1.7;
  const double exact =
      a * b * c + 2 * r * (a * b + b * c + c * a) + M_PI * r * r * (a + b + c) + 4 * M_PI * r * r * r / 3;
  EXPECT_NEAR(volume(mesh_of(RoundedPrism(square(r), {}, c + 2 * r, r))) / exact, 1, 3e-3);
  EXPECT_NEAR(volume(mesh_of(RoundedPrism(square(r), {}, c + 2 * r, r, true))) / exact, -1, 3e-3);
}

TEST(SurfaceMesh, WhatHasNoEndIsShownInTheWindow) {
  const SurfaceMesh plate = surface_mesh(PlaneSurface({0, 0, 1}, {0, 0, 1}, 2), WINDOW);
  EXPECT_EQ(plate.triangles.size(), 2u);
  EXPECT_NEAR(area(plate), 6 * 4, 1e-13);
  const SurfaceMesh roller = surface_mesh(Extruded(std::make_shared<Circle>(2.), {}), WINDOW);
  Eigen::AlignedBox3d box;
  for (const auto& point : roller.points) box.extend(point);
  EXPECT_LE(box.min()[2], -1);
  EXPECT_GE(box.max()[2], 4);
}

TEST(SurfaceMesh, WhereTheToolIs) {
  const Tool<3> tool("box", std::make_shared<RoundedPrism>(square(0.4), AxisFrame(), 2.5, 0.4),
                     std::make_shared<CartesianInSpace>());
  const Eigen::VectorXd q = (Eigen::VectorXd(6) << 1, -2, 0.5, 0.4, -0.8, 1.1).finished();
  const SurfaceMesh mesh = surface_mesh(tool, q, WINDOW);
  const Pose<3> pose = tool.coordinates().pose(q);
  for (const auto& point : mesh.points) ASSERT_NEAR(tool.foot(pose, point, ANY).gap, 0, 1e-12);
  expect_invalid([&] { surface_mesh(tool, q, Eigen::AlignedBox3d()); }, "surface_mesh: ");
  expect_invalid(
      [&] {
        surface_mesh(tool, q, {Vector<3>(0, 0, 0), Vector<3>(0, 0, 0)});
      },
      "surface_mesh: sizes of the window");
}

TEST(PolygonTriangles, FillPolygonsThatAreNotConvex) {
  const std::vector<Vector<2>> comb{{0, 0}, {4, 0}, {4, 3}, {3, 3},   {3, 1}, {2, 1},
                                    {2, 3}, {1, 3}, {1, 1}, {0.5, 1}, {0, 1}};
  for (const bool turned : {false, true}) {
    std::vector<Vector<2>> corners = comb;
    if (turned) std::reverse(corners.begin(), corners.end());
    double sum = 0;
    for (const auto& t : polygon_triangles(corners)) {
      const auto at = [&](int i) {
        return corners[static_cast<std::size_t>(t[static_cast<std::size_t>(i)])];
      };
      const Vector<2> u = at(1) - at(0), v = at(2) - at(0);
      EXPECT_GT(u[0] * v[1] - u[1] * v[0], 0) << "counter-clockwise";
      sum += (u[0] * v[1] - u[1] * v[0]) / 2;
    }
    EXPECT_NEAR(sum, 4 + 2 + 2, 1e-14);
  }
}
