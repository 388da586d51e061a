// Surfaces of space, every kind: the foot is the closest point, the frame against differences, motions along the
// surface.
#include "unit/finite_difference.hpp"
#include "unit/geometry/surface_samples.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

const Param<3> ANY(0, 0);

} // namespace

TEST(SurfacesInSpace, TheFootIsTheClosestPoint) {
  RandomPoints random;
  for (const auto& [name, surface] : surfaces(skew_axis())) {
    const auto samples = surface->samples(2000);
    ASSERT_EQ(samples.size(), 2000u);
    for (int i = 0; i < 300; ++i) {
      SCOPED_TRACE(name + " point " + std::to_string(i));
      const Vector<3> p = random.point(6);
      const SurfaceFoot<3> foot = surface->foot(p, ANY);
      const SurfaceFrame<3> frame = surface->frame(foot.place);
      const double distance = (p - foot.place.y).norm();
      EXPECT_NEAR(std::abs(foot.gap), distance, 1e-13);
      if (!foot.on_end)
        expect_close(Vector<3>(foot.place.y + foot.gap * frame.n), p, 1, 1e-13, "foot + gap n");
      for (const auto& sample : samples) ASSERT_GE((p - sample.y).norm(), distance - 1e-13);
    }
  }
}

TEST(SurfacesInSpace, APlaceIsItsOwnFoot) {
  for (const auto& [name, surface] : surfaces(skew_axis()))
    for (const auto& place : smooth_places(*surface, 60, 0.05)) {
      SCOPED_TRACE(name);
      const SurfaceFrame<3> frame = surface->frame(place);
      for (const double gap : {-0.01, 0., 0.02}) {
        const SurfaceFoot<3> foot = surface->foot(place.y + gap * frame.n, place.hint);
        EXPECT_FALSE(foot.on_end);
        EXPECT_NEAR(foot.gap, gap, 1e-14);
        expect_close(foot.place.y, place.y, 1, 2e-14, "foot");
        expect_close(surface->frame(foot.place).n, frame.n, 1, 2e-14, "normal");
      }
    }
}

// dy = E d(eta), dn = E B d(eta), d2y/d(eta)2 = -n B (METHOD.md (2.4)).
TEST(SurfacesInSpace, FrameAgainstDifferencesAlongItsOwnMotion) {
  for (const auto& [name, given] : surfaces(skew_axis())) {
    const auto& surface = given;
    const auto places = smooth_places(*surface, 60, 0.05);
    EXPECT_GE(places.size(), 20u) << name;
    for (const auto& place : places) {
      SCOPED_TRACE(name);
      const SurfaceFrame<3> frame = surface->frame(place);
      Tensor<3> axes;
      axes << frame.E, frame.n;
      expect_close(Tensor<3>(axes.transpose() * axes), Tensor<3>::Identity(), 1, 2e-15, "orthonormal");
      EXPECT_NEAR(axes.determinant(), 1, 2e-15) << "n = E_0 x E_1";
      const double radius = 1 / std::max(1., frame.B.norm()), step = 1e-3 * radius;
      for (int a = 0; a < 2; ++a) {
        const auto moved = [&](double t) { return surface->moved(place, t * Param<3>::Unit(a)); };
        const auto slope = [&](double t) {
          return finite_difference([&](double s) { return moved(s).y; }, t, 2 * step);
        };
        const Vector<3> n_a =
            finite_difference([&](double t) { return surface->frame(moved(t)).n; }, 0, step);
        expect_close(Vector<3>(frame.E.col(a)), slope(0), 1, 1e-10, "E");
        expect_close(Vector<3>(frame.E * frame.B.col(a)), n_a, 1 / radius, 1e-9, "dn");
        expect_close(Vector<3>(-frame.n * frame.B(a, a)), finite_difference(slope, 0, 2 * step), 1 / radius,
                     1e-8, "d2y");
      }
    }
  }
}

// y(eta) is y + E eta - n (eta'B eta)/2 but for terms of third order.
TEST(SurfacesInSpace, MotionIsOfSecondOrder) {
  for (const auto& [name, given] : surfaces(skew_axis()))
    for (const auto& place : smooth_places(*given, 40, 0.1)) {
      const auto& surface = given;
      const SurfaceFrame<3> frame = surface->frame(place);
      const auto error = [&](double size) {
        const Param<3> eta = size * Param<3>(0.6, -0.8);
        const Vector<3> expected = place.y + frame.E * eta - frame.n * (0.5 * eta.dot(frame.B * eta));
        return (surface->moved(place, eta).y - expected).norm();
      };
      EXPECT_LE(error(0.02), 0.16 * error(0.04) + 1e-14) << name;
    }
}

TEST(SurfacesInSpace, SlipIsTheChordOnTheTangentPlane) {
  const AxisFrame axis = skew_axis();
  const auto ball = sphere(2, axis);
  const SurfacePlace<3> from = ball->samples(7)[3];
  for (const double length : {1e-6, 0.1, 1.5}) {
    const SurfacePlace<3> to = ball->moved(from, length * Param<3>(0.6, 0.8));
    const Param<3> slip = ball->slip(from, to);
    EXPECT_NEAR(slip.norm(), 2 * std::sin(std::atan(length / 2)), 1e-15);
    const Vector<3> pole =
        (from.y - axis.point).cross(ball->frame(from).E * Vector<2>(0.6, 0.8)).normalized();
    EXPECT_NEAR(pole.dot(ball->frame(to).E * slip) / slip.norm(), 0, 1e-9) << "along the great circle";
  }
}

// A surface about a moved axis is the moved surface.
TEST(SurfacesInSpace, MovedAxisMovesTheSurface) {
  const AxisFrame at_home, away = skew_axis();
  const auto home = surfaces(at_home), moved = surfaces(away);
  RandomPoints random;
  for (std::size_t k = 0; k < home.size(); ++k)
    for (int i = 0; i < 50; ++i) {
      SCOPED_TRACE(home[k].name + " point " + std::to_string(i));
      const Vector<3> p = random.point(6);
      const auto foot = home[k].surface->foot(p, ANY), there = moved[k].surface->foot(away.global(p), ANY);
      const auto frame = home[k].surface->frame(foot.place), turned = moved[k].surface->frame(there.place);
      EXPECT_NEAR(foot.gap, there.gap, 2e-14);
      EXPECT_EQ(foot.on_end, there.on_end);
      expect_close(there.place.y, away.global(foot.place.y), 1, 2e-14, "foot");
      expect_close(turned.n, Vector<3>(away.base * frame.n), 1, 2e-14, "normal");
      const Tensor<3> W = frame.E * frame.B * frame.E.transpose();
      expect_close(Tensor<3>(turned.E * turned.B * turned.E.transpose()),
                   Tensor<3>(away.base * W * away.base.transpose()), 1 + W.norm(), 2e-13, "grad n");
    }
}

TEST(SurfacesInSpace, HintsDoNotCount) {
  RandomPoints random;
  for (const auto& [name, surface] : surfaces(skew_axis()))
    for (int i = 0; i < 50; ++i) {
      const Vector<3> p = random.point(6);
      const auto foot = surface->foot(p, ANY), other = surface->foot(p, Param<3>(40, -7));
      expect_close(other.place.y, foot.place.y, 1, 4e-14, name);
      expect_close(surface->frame(other.place).n, surface->frame(foot.place).n, 1, 4e-14, name);
      EXPECT_NEAR(other.gap, foot.gap, 1e-15);
    }
}

TEST(SurfacesInSpace, Errors) {
  for (const auto& [name, surface] : surfaces(skew_axis()))
    expect_invalid([&s = surface] { s->foot(Vector<3>(0, std::nan(""), 0), ANY); }, "::foot: p = ");
  expect_invalid([] { PlaneSurface(Vector<3>(0, 0, 0), Vector<3>(0, 0, 0), 1); },
                 "PlaneSurface: direction of the axis = 0 0 0, expected finite components, not all 0");
  expect_invalid([] { PlaneSurface(Vector<3>(0, 0, 0), Vector<3>(0, 0, 1), 0); }, "size = 0");
  expect_invalid(
      [] {
        axis_frame("roll", {0, 0, 0}, {1, 0, 0}, {-2, 0, 0});
      },
      "roll: direction across the axis = -2  0  0, expected finite components, not along");
  expect_invalid([] { axis_frame("roll", {0, 0, INFINITY}, {1, 0, 0}); }, "roll: point of the axis");
  expect_invalid([] { sphere(-1); }, "sphere: radius = -1, expected a finite number > 0");
  expect_invalid([] { cylinder(1, 0); }, "cylinder: length = 0");
  expect_invalid([] { cone(0, 0, 1); }, "cone: second radius = 0, expected > 0, or the first one");
  expect_invalid([] { cone(1, -2, 1); }, "cone: second radius = -2");
  expect_invalid([] { torus(1, 1); }, "torus: radius of the tube = 1, expected > 0 and less than");
}
