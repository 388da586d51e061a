// Tools in space: every surface placed by several kinds of coordinates, points against differences, feet against the surface.
#include "kinematics/cartesian_in_space.hpp"
#include "kinematics/formula_coordinates.hpp"
#include "kinematics/polar_in_space.hpp"
#include "kinematics/tool.hpp"
#include "kinematics/tool_foot.hpp"
#include "unit/finite_difference.hpp"
#include "unit/geometry/surface_samples.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

struct Placed {
  std::shared_ptr<const Coordinates<3>> coordinates;
  Eigen::VectorXd q;
};

std::vector<Placed> placed() {
  const auto tilted = std::make_shared<FormulaCoordinates<3>>(
      "tool", std::vector<std::string>{"h", "phi", "tilt"}, SpaceFormulas{"0", "h*phi", "h", "z:phi x:tilt"});
  return {
      {std::make_shared<CartesianInSpace>(), (Eigen::VectorXd(6) << 1, -2, 0.5, 0.4, -0.8, 1.1).finished()},
      {std::make_shared<PolarInSpace>(skew_axis()), Eigen::Vector4d(1.2, 0.7, -0.4, 2)},
      {tilted, Eigen::Vector3d(0.6, -1.3, 0.4)}};
}

} // namespace

TEST(ToolInSpace, PointAgainstDifferences) {
  for (const auto& [name, surface] : surfaces(skew_axis()))
    for (const Placed& where : placed()) {
      SCOPED_TRACE(name);
      const Tool<3> tool(name, surface, where.coordinates);
      const SurfacePlace<3> place = smooth_places(*surface, 40, 0.05).at(2);
      const SurfacePoint<3> point = tool.point(where.q, place);
      for (int k = 0; k < where.coordinates->size(); ++k) {
        const auto moved = [&](double t) {
          Eigen::VectorXd q = where.q;
          q[k] = t;
          return tool.point(q, place);
        };
        const auto check = [&](const auto& member, const auto& derivative, const char* what) {
          const auto expected =
              finite_difference([&](double t) { return member(moved(t)); }, where.q[k], 1e-3);
          expect_close(derivative, expected, 1, 1e-9, what);
        };
        using P = const SurfacePoint<3>&;
        check([](P p) { return p.x; }, Vector<3>(point.x_q.col(k)), "X_k");
        check([](P p) { return p.n; }, Vector<3>(point.n_q.col(k)), "n_k");
        for (int a = 0; a < 2; ++a)
          check([a](P p) { return Vector<3>(p.E.col(a)); }, Vector<3>(point.E_q[a].col(k)), "E_k");
        for (int l = 0; l < where.coordinates->size(); ++l)
          check([l](P p) { return Vector<3>(p.x_q.col(l)); }, Vector<3>(point.x_qq[l].col(k)), "X_kl");
      }
    }
}

// The gap changes by n dx, n by E H E' dx with H = (1 + gap B)^-1 B (ToolFoot).
TEST(ToolInSpace, FeetOfPointsThatMove) {
  for (const auto& [name, surface] : surfaces(skew_axis()))
    for (const Placed& where : placed()) {
      SCOPED_TRACE(name);
      const Tool<3> tool(name, surface, where.coordinates);
      const SurfacePoint<3> point = tool.point(where.q, smooth_places(*surface, 40, 0.05).at(3));
      const Vector<3> x = point.x + 0.02 * point.n;
      const auto foot = [&](const Vector<3>& at) { return tool_feet(tool, where.q, {at})[0]; };
      const ToolFoot<3> here = foot(x);
      EXPECT_NEAR(here.gap, 0.02, 1e-14);
      expect_close(here.x, point.x, 1, 1e-14, "foot");
      const Curvature<3> H = (Curvature<3>::Identity() + here.gap * here.B).inverse() * here.B;
      const Tensor<3> n_x = here.E * H * here.E.transpose();
      for (int i = 0; i < 3; ++i) {
        const auto along = [&](double t) { return foot(x + t * Vector<3>::Unit(i)); };
        EXPECT_NEAR(finite_difference([&](double t) { return along(t).gap; }, 0, 1e-4), here.n[i], 1e-9);
        expect_close(Vector<3>(n_x.col(i)), finite_difference([&](double t) { return along(t).n; }, 0, 1e-4),
                     1 + H.norm(), 1e-9, "dn");
      }
    }
}
