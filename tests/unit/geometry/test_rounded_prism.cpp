// Boxes, drums and prisms with rounded edges: closest points in closed form, pieces, what is refused.
#include "unit/finite_difference.hpp"
#include "unit/geometry/surface_samples.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

const Param<3> ANY(0, 0);

/// Distance of p from a box whose edges have the radius r.
double from_box(const Vector<3>& p, const Vector<3>& half, double r) {
  const Vector<3> beyond = p.cwiseAbs() - half + Vector<3>::Constant(r);
  if (beyond.maxCoeff() <= 0) return beyond.maxCoeff() - r;
  return beyond.cwiseMax(0).norm() - r;
}

} // namespace

TEST(RoundedPrism, ABoxInClosedForm) {
  const double r = 0.4;
  const Vector<3> half(2, 1.5, 1.25);
  RandomPoints random;
  for (const bool inside : {false, true}) {
    const RoundedPrism box(square(r), skew_axis(), 2 * half[2], r, inside);
    for (int i = 0; i < 2000; ++i) {
      const Vector<3> p = random.point(3);
      const auto foot = box.foot(skew_axis().global(p), ANY);
      EXPECT_NEAR(foot.gap, (inside ? -1 : 1) * from_box(p, half, r), 1e-14);
      EXPECT_FALSE(foot.on_end);
      EXPECT_NEAR(from_box(skew_axis().local(foot.place.y), half, r), 0, 1e-14);
    }
    EXPECT_TRUE(box.closed());
    EXPECT_NEAR(box.tightest_radius(), r, 1e-15);
  }
}

// Corners of a box are spheres, edges cylinders, sides planes.
TEST(RoundedPrism, CurvaturesOfABox) {
  const double r = 0.4;
  const RoundedPrism box(square(r), {}, 2.5, r);
  const auto frame = [&](const Vector<3>& p) { return box.frame(box.foot(p, ANY).place); };
  expect_close(frame({3, 3, 3}).B, Curvature<3>(Curvature<3>::Identity() / r), 1, 1e-14, "corner");
  for (const Vector<3>& p : {Vector<3>(3, 3, 0.2), Vector<3>(3, 0.1, 3), Vector<3>(0.3, -3, -3)}) {
    const Curvature<3> B = frame(p).B;
    EXPECT_NEAR(B.trace(), 1 / r, 1e-14);
    EXPECT_NEAR(B.determinant(), 0, 1e-14);
  }
  for (const Vector<3>& p : {Vector<3>(3, 0.1, 0.2), Vector<3>(0.1, -3, 0.2), Vector<3>(0.1, 0.2, -3)})
    EXPECT_EQ(frame(p).B, Curvature<3>::Zero());
}

// The same drum as a turned chain from pole to pole.
TEST(RoundedPrism, ADrumIsATurnedChain) {
  const double R = 1.5, half = 2, r = 0.4;
  for (const bool inside : {false, true}) {
    const RoundedPrism drum(std::make_shared<Circle>(R), skew_axis(), 2 * half, r, inside);
    const Revolved turned(
        std::make_shared<ArcChain>(std::vector<Vector<2>>{{0, half}, {R, half}, {R, -half}, {0, -half}},
                                   std::vector<double>{0, r, r, 0}, false, inside),
        skew_axis());
    RandomPoints random;
    for (int i = 0; i < 1000; ++i) {
      const Vector<3> p = skew_axis().point + random.point(3);
      const auto a = drum.foot(p, ANY), b = turned.foot(p, ANY);
      EXPECT_NEAR(a.gap, b.gap, 1e-14);
      if (std::abs(a.gap) > 1.2) continue; // two may be equally near within
      expect_close(a.place.y, b.place.y, 1, 1e-13, "foot");
      const auto f = drum.frame(a.place), g = turned.frame(b.place);
      expect_close(f.n, g.n, 1, 1e-13, "normal");
      expect_close(Tensor<3>(f.E * f.B * f.E.transpose()), Tensor<3>(g.E * g.B * g.E.transpose()), 1, 1e-11,
                   "grad n");
    }
  }
}

// A node that slides off the end and down the wall passes end, edge and wall.
TEST(RoundedPrism, PiecesOfAWayOverTheEdge) {
  const RoundedPrism drum(std::make_shared<Circle>(1.5), skew_axis(), 4, 0.4);
  const auto place = [&](double x, double z) {
    return drum.foot(skew_axis().global({x, 0.1, z}), ANY).place;
  };
  const auto end = place(0.5, 3), edge = place(1.7, 2.2), wall = place(2, 0.3), other = place(1.7, -2.2);
  std::vector<int> pieces;
  for (const auto& at : {end, edge, wall, other, place(0.5, -3)}) pieces.push_back(drum.piece(at));
  std::sort(pieces.begin(), pieces.end());
  EXPECT_EQ(std::unique(pieces.begin(), pieces.end()), pieces.end()) << "five pieces";
  for (const auto& [from, to] :
       {std::make_pair(end, edge), std::make_pair(edge, wall), std::make_pair(wall, other)}) {
    const double part = drum.passage(from, to);
    ASSERT_LE(part, 1);
    const auto before = drum.frame(drum.between(from, to, part - 1e-9)),
               after = drum.frame(drum.between(from, to, part));
    expect_close(before.n, after.n, 1, 1e-7, "normal");
    EXPECT_GT((before.B - after.B).norm(), 0.1) << "the curvature jumps";
  }
}

TEST(RoundedPrism, WhatIsRefused) {
  const auto circle = std::make_shared<Circle>(1.5);
  expect_invalid([&] { RoundedPrism(circle, {}, 4, 0); },
                 "RoundedPrism: fillet = 0, expected a finite number > 0");
  expect_invalid([&] { RoundedPrism(circle, {}, -4, 1); }, "RoundedPrism: length = -4");
  expect_invalid([&] { RoundedPrism(circle, {}, 4, 2.1); },
                 "RoundedPrism: fillet = 2.1, expected up to half the length");
  expect_invalid([&] { RoundedPrism(circle, {}, 4, 1.6); },
                 "RoundedPrism: a fillet of radius 1.6 does not fit into the section at (1.5, 0)");
  expect_invalid([&] { RoundedPrism(square(0.3), {}, 4, 0.4); }, "does not fit into the section at (");
  expect_invalid(
      [&] { RoundedPrism(std::make_shared<Segment>(Vector<2>(0, 0), Vector<2>(1, 0)), {}, 4, 0.1); },
      "RoundedPrism: the section is open, expected a closed one");
  // a waist of 0.4 between two lobes: a circle of 0.3 rolls in the lobes, not through the waist
  const auto waist = std::make_shared<ArcChain>(
      std::vector<Vector<2>>{{2, 1}, {0, 0.2}, {-2, 1}, {-2, -1}, {0, -0.2}, {2, -1}},
      std::vector<double>{0.35, 0.5, 0.35, 0.35, 0.5, 0.35}, true);
  EXPECT_NO_THROW(RoundedPrism(waist, {}, 4, 0.2));
  expect_invalid([&] { RoundedPrism(waist, {}, 4, 0.35); }, "does not fit into the section");
}
