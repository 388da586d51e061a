// What is particular to surfaces of revolution and extrusion: closed forms, poles, axes, apices, joints, rims.
#include "unit/finite_difference.hpp"
#include "unit/geometry/surface_samples.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

constexpr double INF = std::numeric_limits<double>::infinity();
const Param<3> ANY(0, 0);

/// grad n at the foot of p.
Tensor<3> shape_operator(const Surface<3>& surface, const Vector<3>& p) {
  const SurfaceFrame<3> frame = surface.frame(surface.foot(p, ANY).place);
  return frame.E * frame.B * frame.E.transpose();
}

void expect_sphere(const Surface<3>& ball, const Vector<3>& center, double R, double side,
                   const Vector<3>& p) {
  const SurfaceFoot<3> foot = ball.foot(p, ANY);
  const SurfaceFrame<3> frame = ball.frame(foot.place);
  const Vector<3> out = (p - center).normalized();
  EXPECT_NEAR(foot.gap, side * ((p - center).norm() - R), 1e-14);
  EXPECT_FALSE(foot.on_end);
  expect_close(foot.place.y, Vector<3>(center + R * out), 1, 3e-15, "foot");
  expect_close(frame.n, Vector<3>(side * out), 1, 3e-15, "normal");
  expect_close(Tensor<3>(frame.E * frame.B * frame.E.transpose()),
               Tensor<3>(side / R * (Tensor<3>::Identity() - out * out.transpose())), 1, 1e-8, "grad n");
  expect_close(frame.B, Curvature<3>(side / R * Curvature<3>::Identity()), 1, 2e-15, "B");
}

} // namespace

TEST(TurnedSurfaces, TheSphereHasNoPoles) {
  const AxisFrame axis = skew_axis();
  const double R = 2.5;
  RandomPoints random;
  for (const bool inside : {false, true}) {
    const auto ball = sphere(R, axis, inside);
    const double side = inside ? -1 : 1;
    for (int i = 0; i < 200; ++i) expect_sphere(*ball, axis.point, R, side, axis.point + random.point(4));
    for (const double off : {0., 1e-300, 1e-17, 1e-13, 1e-10, 1e-8, 3e-7, 1e-5, 1e-3})
      for (const double end : {-3., -1., 2.}) {
        SCOPED_TRACE("off the axis by " + std::to_string(off) + " at " + std::to_string(end));
        expect_sphere(*ball, axis.point, R, side, axis.global({0.6 * off, -0.8 * off, end}));
      }
    EXPECT_TRUE(ball->closed());
    EXPECT_TRUE(ball->ends().empty());
    EXPECT_EQ(ball->tightest_radius(), R);
    EXPECT_NEAR(ball->length_scale(), R, 1e-15);
  }
}

// A node slides over a pole and around the seam: places and normals are continuous.
TEST(TurnedSurfaces, AWayOverThePole) {
  const auto ball = sphere(1);
  SurfacePlace<3> place = ball->foot({-0.2, 0, 1}, ANY).place;
  for (int i = 0; i < 40; ++i) {
    const Tangents<3> E = ball->frame(place).E;
    const Param<3> eta =
        0.01 * (E.transpose() * Vector<3>::UnitX()).normalized(); // along x, exactly over the pole
    const SurfacePlace<3> next = ball->moved(place, eta);
    EXPECT_NEAR(next.y[1], 0, 1e-15);
    EXPECT_NEAR((next.y - place.y).norm(), 2 * std::sin(std::atan(0.01) / 2), 1e-12);
    place = next;
  }
  EXPECT_GT(place.y[0], 0.19);
}

TEST(TurnedSurfaces, ShapeOperatorsInClosedForm) {
  RandomPoints random;
  const Vector<3> a = Vector<3>::UnitZ();
  for (int i = 0; i < 100; ++i) {
    const Vector<3> p(random.number(-3, 3), random.number(-3, 3), random.number(0.5, 1.5));
    const double r = p.head<2>().norm();
    const Vector<3> e(p[0] / r, p[1] / r, 0), c = a.cross(e);
    expect_close(shape_operator(*cylinder(1.5, 2), p), Tensor<3>(c * c.transpose() / 1.5), 1, 1e-14,
                 "cylinder");
    expect_close(shape_operator(*cylinder(1.5, 2, {}, true), p), Tensor<3>(-c * c.transpose() / 1.5), 1,
                 1e-14, "hollow cylinder");
    const auto roller = Extruded(std::make_shared<Circle>(1.5), {}, 2);
    expect_close(shape_operator(roller, p), Tensor<3>(c * c.transpose() / 1.5), 1, 1e-14, "roller");
    const auto nappe = cone(1, 4, 3); // half angle of 45 degrees
    const SurfaceFoot<3> foot = nappe->foot(p, ANY);
    if (!foot.on_end)
      expect_close(shape_operator(*nappe, p),
                   Tensor<3>(c * c.transpose() * std::sqrt(0.5) / foot.place.y.head<2>().norm()), 1, 1e-14,
                   "cone");
    const Vector<3> n = (p - 3 * e).normalized(), b = n.cross(c);
    const double rho = 3 + 1.2 * n.dot(e);
    expect_close(shape_operator(*torus(3, 1.2), p),
                 Tensor<3>(b * b.transpose() / 1.2 + c * c.transpose() * n.dot(e) / rho), 1, 1e-13, "torus");
  }
}

TEST(TurnedSurfaces, ThePoleOfAPunch) {
  const Revolved die(punch(), skew_axis());
  for (const double off : {0., 1e-12, 1e-6, 0.3}) { // under its flat: the body is below it
    const SurfaceFoot<3> foot = die.foot(skew_axis().global({0, off, -0.25}), ANY);
    EXPECT_FALSE(foot.on_end);
    EXPECT_NEAR(foot.gap, 0.25, 1e-15);
    EXPECT_EQ(die.frame(foot.place).B, Curvature<3>::Zero());
    expect_close(die.frame(foot.place).n, Vector<3>(-skew_axis().base.col(2)), 1, 1e-15, "normal");
    EXPECT_GT(die.distance_to_end(foot.place), 3);
  }
  EXPECT_FALSE(die.closed()) << "its flange has a rim";
  ASSERT_EQ(die.ends().size(), std::size_t(Revolved::RIM_PLACES));
  for (const auto& end : die.ends()) {
    EXPECT_NEAR(skew_axis().local(end.y).head<2>().norm(), 5, 1e-14);
    EXPECT_NEAR(skew_axis().local(end.y)[2], 2.5, 1e-14);
    EXPECT_EQ(die.distance_to_end(end), 0);
  }
  EXPECT_EQ(die.tightest_radius(), 0.4);
}

// A capsule of an open chain from pole to pole is closed; a half-turn profile equals the circle.
TEST(TurnedSurfaces, AChainFromPoleToPoleIsClosed) {
  const double R = 1.5;
  const auto half = std::make_shared<ArcChain>(std::vector<Vector<2>>{{0, 2 * R}, {R, 2 * R}, {R, 0}, {0, 0}},
                                               std::vector<double>{0, R, R, 0});
  const Revolved ball(half);
  EXPECT_TRUE(ball.closed());
  EXPECT_TRUE(ball.ends().empty());
  EXPECT_EQ(ball.distance_to_end(ball.samples(3)[1]), INF);
  RandomPoints random;
  const auto exact = sphere(R, axis_frame("test", {0, 0, R}, {0, 0, 1}));
  for (int i = 0; i < 300; ++i) {
    Vector<3> p = random.point(4);
    if (i % 3 == 0) p.head<2>() *= std::pow(10., -i / 20.);
    const auto foot = ball.foot(p, ANY), other = exact->foot(p, ANY);
    EXPECT_FALSE(foot.on_end);
    EXPECT_NEAR(foot.gap, other.gap, 1e-14);
    expect_close(foot.place.y, other.place.y, 1, 1e-14, "foot");
    expect_close(ball.frame(foot.place).B, exact->frame(other.place).B, 1, 1e-8,
                 "B"); // n_r/r beside the axis
  }
}

TEST(TurnedSurfaces, AnApexIsAnEnd) {
  const auto nappe = cone(0, 2, 2, skew_axis());
  const SurfaceFoot<3> foot = nappe->foot(skew_axis().global({0.1, 0, -1}), ANY);
  EXPECT_TRUE(foot.on_end);
  EXPECT_NEAR(foot.gap, std::sqrt(1.01), 1e-15);
  expect_close(foot.place.y, skew_axis().point, 1, 1e-15, "apex");
  EXPECT_TRUE(nappe->frame(foot.place).B.allFinite());
  EXPECT_EQ(nappe->ends().size(), 1u + Revolved::RIM_PLACES);
  EXPECT_FALSE(nappe->closed());
}

// On the axis of a torus or a cylinder all half-planes are equally near: the hint decides.
TEST(TurnedSurfaces, OnTheAxisTheHintDecides) {
  for (const auto& [surface, radius] : {std::make_pair(torus(3, 1), 2.), std::make_pair(cylinder(2, 2), 2.)})
    for (const double angle : {0., 0.7, -4.}) {
      const SurfaceFoot<3> foot = surface->foot({0, 0, 0}, Param<3>(3, angle));
      expect_close(foot.place.y, Vector<3>(radius * std::cos(angle), radius * std::sin(angle), 0), 1, 1e-15,
                   "foot");
    }
}

TEST(TurnedSurfaces, JointsOfTheProfile) {
  const auto check = [](const Surface<3>& surface, const SurfacePlace<3>& from, const SurfacePlace<3>& to) {
    const double part = surface.passage(from, to);
    ASSERT_LE(part, 1);
    const auto before = surface.between(from, to, part - 1e-9), after = surface.between(from, to, part);
    EXPECT_EQ(surface.piece(before), surface.piece(from));
    EXPECT_NE(surface.piece(after), surface.piece(from));
    const auto f = surface.frame(before), g = surface.frame(after);
    expect_close(f.n, g.n, 1, 1e-7, "normal");
    EXPECT_GT((f.B - g.B).norm(), 0.1) << "the curvature jumps";
    EXPECT_EQ(surface.passage(from, from), INF);
  };
  const AxisFrame axis = skew_axis();
  const Revolved die(punch(), axis);
  const auto flat = [&](double x, double y) { return die.foot(axis.global({x, y, -0.1}), ANY).place; };
  check(die, flat(0.5, 0.3), flat(1.9, 0.5));   // off the flat to the corner
  check(die, flat(-1.9, 0.5), flat(0.5, -0.3)); // back
  const Extruded bar(cam(), axis, 5);
  check(bar, bar.foot(axis.global({3, -1, 1}), ANY).place, bar.foot(axis.global({7.5, -1, 3}), ANY).place);
  const auto outline = die.outline(40);
  EXPECT_GE(outline.size(), 40u + 4) << "with the joints of the profile";
  EXPECT_EQ(die.piece(outline.front()), 0);
}

TEST(TurnedSurfaces, RimsOfABar) {
  const AxisFrame axis = skew_axis();
  const Extruded plate(std::make_shared<Segment>(Vector<2>(0, 0), Vector<2>(4, 0)), axis, 3);
  const auto foot = [&](double x, double y, double z) { return plate.foot(axis.global({x, y, z}), ANY); };
  EXPECT_NEAR(foot(1, 0.5, 2).gap, 0.5, 1e-15);
  EXPECT_NEAR(foot(1, -0.5, 2).gap, -0.5, 1e-15) << "the body is on the left of the profile";
  EXPECT_NEAR(plate.distance_to_end(foot(1, 0.5, 1.5).place), 1, 1e-15);
  EXPECT_NEAR(plate.distance_to_end(foot(2, 0.5, 2.75).place), 0.25, 1e-15);
  for (const Vector<3>& p :
       {Vector<3>(1, -3, 7), Vector<3>(1, 3, -4), Vector<3>(8, -3, 3), Vector<3>(-3, 0, -4)}) {
    const SurfaceFoot<3> end = plate.foot(axis.global(p), ANY);
    EXPECT_TRUE(end.on_end);
    EXPECT_NEAR(end.gap, 5, 1e-14);
    EXPECT_NEAR(plate.distance_to_end(end.place), 0, 1e-15);
  }
  EXPECT_FALSE(foot(1, -0.5, 3 + 1e-14).on_end) << "the end itself";
  EXPECT_EQ(plate.ends().size(), 4u * Extruded::RIM_PLACES);
  for (const auto& end : plate.ends()) EXPECT_NEAR(plate.distance_to_end(end), 0, 2e-15);
  EXPECT_EQ(plate.length_scale(), 4);
  EXPECT_EQ(plate.tightest_radius(), INF);
}

TEST(TurnedSurfaces, Lengths) {
  EXPECT_NEAR(torus(3, 1.2)->length_scale(), 4.2, 1e-15);
  EXPECT_EQ(torus(3, 1.2)->tightest_radius(), 1.2);
  EXPECT_NEAR(torus(3, 2)->tightest_radius(), 1, 1e-14) << "about the hole";
  EXPECT_NEAR(cylinder(1.5, 8)->tightest_radius(), 1.5, 1e-15);
  EXPECT_NEAR(cone(1, 2, 1)->tightest_radius(), std::sqrt(2.), 1e-14);
  EXPECT_EQ(sphere(2)->outline(9).size(), 9u);
  EXPECT_EQ(PlaneSurface({0, 0, 0}, {0, 0, 1}, 2).outline(3).size(), 3u);
}

TEST(TurnedSurfaces, ProfilesThatCannotBeTurned) {
  const auto line = [](double x, double y, double u, double v) {
    return std::make_shared<Segment>(Vector<2>(x, y), Vector<2>(u, v));
  };
  expect_invalid(
      [&] { Revolved(line(-1, 0, 2, 1)); },
      "Revolved: the profile has a point at r = -1, y = 0 and not its mirror image, expected r >= 0");
  expect_invalid([&] { Revolved(line(0, 0, 0, 1)); }, "Revolved: largest distance from the axis = 0");
  expect_invalid([&] { Revolved(line(1, 0, 2, 1), {}, -1); }, "Revolved: radius = -1");
  expect_invalid([] { Revolved(nullptr); }, "tool: no profile");
  expect_invalid([&] { Extruded(line(0, 0, 1, 1), {}, 0); }, "Extruded: length = 0");
  const Revolved disc(line(-2, 0, 2, 0)); // both sides alike
  EXPECT_EQ(disc.ends().size(), std::size_t(Revolved::RIM_PLACES));
  EXPECT_NEAR(disc.foot({0.3, -1, 0.5}, ANY).gap, 0.5, 1e-15);
  for (const auto& place : disc.samples(9))
    EXPECT_NEAR(disc.distance_to_end(place), 2 - place.y.norm(), 1e-15);
  EXPECT_NEAR(Revolved(line(-1, 0, 1, 0), {}, 1).length_scale(), 2, 1e-15) << "from the axis outwards";
}
