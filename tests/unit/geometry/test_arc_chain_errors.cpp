// Everything an ArcChain refuses: the message tells the place, the numbers and a way out.
#include "geometry/arc_chain.hpp"
#include "unit/finite_difference.hpp"
#include <limits>

using namespace burnish;
using namespace burnish::test;

namespace {
using Points = std::vector<Vector<2>>;
const Param<2> ANY(0.0);
} // namespace

TEST(ArcChainErrors, RefusesCornersWithTheRadiusThatFits) {
  expect_invalid(
      [] {
        ArcChain({{0, 2}, {0, 0}, {3, 0}, {3, 2}}, {0, 0, 1, 0});
      },
      "ArcChain: point 1 at (0, 0) is a corner of 90 degrees without fillet; give it a radius > 0, "
      "up to 2 fits there");
  ArcChain({{0, 2}, {0, 0}, {3, 0}, {3, 2}}, {0, 2, 1, 0});
  expect_invalid([] { ArcChain({{0, 0}, {1, 0}, {2, 1e-8}}, {0, 0, 0}); }, "point 1 at (1, 0) is a corner");
  ArcChain({{0, 0}, {1, 0}, {2, 5e-10}}, {0, 0, 0});
  expect_invalid([] { ArcChain({{0, 0}, {2, 0}, {1, 0}}, {0, 0.1, 0}); }, "turns back on itself at point 1");
}

TEST(ArcChainErrors, RefusesRadiiTooSmallToBeSeen) { // such a fillet was left out: a corner
  expect_invalid(
      [] {
        ArcChain({{0, 2}, {0, 0}, {3, 0}}, {0, 1e-300, 0});
      },
      "radius 1e-300 at point 1 at (0, 0) is too small for a corner of 90 degrees in a chain of size "
      "3.60555; give it more than 2.29537e-12");
  ArcChain({{0, 2}, {0, 0}, {3, 0}}, {0, 3e-12, 0});
}

TEST(ArcChainErrors, CornerBetweenFilletsThatLeaveNoRoom) {
  expect_invalid(
      [] {
        ArcChain({{0, 3}, {0, 0}, {3, 0}, {3, 2}}, {0, 3, 0, 0});
      },
      "point 2 at (3, 0) is a corner of 90 degrees without fillet; give it a radius > 0 and its neighbors "
      "smaller ones, which leave no room");
}

// Radii typed with ten digits leave lines of 1e-10 of the size between them: neighbors, not crossings.
TEST(ArcChainErrors, TinyPiecesAreNoCrossings) {
  for (const double rest : {1e-11, 1e-10, 1e-9}) {
    const double R = 0.5 - rest / 2;
    const ArcChain chain({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {R, R, R, R}, true);
    EXPECT_EQ(chain.pieces().size(), 8u);
    EXPECT_NEAR(chain.closest_point({0.5, 0.5}, ANY).gap, -0.5, 1e-12);
    ArcChain({{-1, 0}, {0, 0}, {1, 1e-7}}, {0, rest * 1e7, 0}); // an arc as long as rest
  }
}

TEST(ArcChainErrors, RefusesFilletsThatOverlap) {
  const Points points{{0, 2}, {0, 0}, {3, 0}, {3, 2}};
  expect_invalid(
      [&] {
        ArcChain(points, {0, 2, 2, 0});
      },
      "no room for the fillets between point 1 at (0, 0) and point 2 at (3, 0): their distance is "
      "3, radius 2 at point 1 takes 2, radius 2 at point 2 takes 2; 0.75 times the radii would fit");
  ArcChain(points, {0, 1.5, 1.5, 0});
  expect_invalid(
      [&] {
        ArcChain(points, {0, 2.1, 0.1, 0});
      },
      "between point 0 at (0, 2) and point 1 at (0, 0): their distance is 2, radius 2.1 at point 1");
}

TEST(ArcChainErrors, RefusesChainsThatCrossThemselves) {
  expect_invalid(
      [] {
        ArcChain({{0, 0}, {4, 0}, {4, 3}, {2, 3}, {2, -2}}, {0, 1, 1, 1, 0});
      },
      "crosses or touches itself at (2, 0): the line from point 0 to point 1 and the line from point "
      "3 to point 4");
  // line and fillet, fillet and fillet, touching only
  expect_invalid(
      [] {
        ArcChain({{0, 0}, {4, 0}, {4, 3}, {3.9, 3}, {3.9, -2}}, {0, 1, 0.02, 0.02, 0});
      },
      "the fillet at point 1 and the line from point 3 to point 4");
  expect_invalid(
      [] {
        ArcChain({{0, 0}, {4, 0}, {4, 3}, {-3, 3}, {-3, -1}, {4, -1}, {4, 2}}, {0, 1, 1, 1, 1, 1, 0});
      },
      "crosses or touches itself");
  expect_invalid([] { ArcChain({{0, 0}, {4, 0}, {4, 3}, {2, 3}, {2, 0}}, {0, 1, 1, 1, 0}); }, "at (2, 0)");
  expect_invalid([] { ArcChain({{0, 0}, {4, 3}, {0, 3}, {4, 0}}, {.1, .1, .1, .1}, true); }, "at (2, 1.5)");
  expect_invalid(
      [] {
        ArcChain({{0, 0}, {4, 0}, {4, 3}, {0, 0}}, {0, 1, 0.5, 0});
      },
      "(if it is meant to be closed: closed, without the last point)");
}

TEST(ArcChainErrors, RefusesBadInput) {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  const Points three{{0, 0}, {2, 0}, {2, 2}};
  expect_invalid([] { ArcChain({{0, 0}}, {0}); }, "ArcChain: number of points = 1, expected at least 2");
  expect_invalid(
      [] {
        ArcChain({{0, 0}, {1, 0}}, {1, 1}, true);
      },
      "number of points = 2, expected at least 3");
  expect_invalid([&] { ArcChain(three, {0, 1}); }, "number of radii = 2, expected one per point: 3");
  expect_invalid(
      [&] {
        ArcChain({{0, 0}, {2, nan}, {2, 2}}, {0, 1, 0});
      },
      "point 1 = (2, nan), expected finite");
  expect_invalid(
      [&] {
        ArcChain(three, {0, inf, 0});
      },
      "radius at point 1 = inf, expected a finite number >= 0");
  expect_invalid(
      [&] {
        ArcChain(three, {0, -1, 0});
      },
      "radius at point 1 = -1, expected a finite number >= 0");
  expect_invalid([&] { ArcChain(three, {0, 1, 0.5}); }, "radius at point 2 = 0.5, expected 0 at the end");
  expect_invalid(
      [] {
        ArcChain({{0, 0}, {2, 0}, {2, 0}}, {0, 1, 0});
      },
      "points 1 and 2 are the same, (2, 0)");
  expect_invalid(
      [] {
        ArcChain({{0, 0}, {2, 0}, {2, 2}, {0, 0}}, {.1, .1, .1, .1}, true);
      },
      "points 3 and 0 are the same, (0, 0): a closed chain returns to its first point by itself");
  const ArcChain chain(three, {0, 1, 0});
  expect_invalid([&] { chain.evaluate(Param<2>(nan)); },
                 "ArcChain::evaluate: s = nan, expected a finite arc");
  expect_invalid([&] { chain.piece(Param<2>(nan)); }, "ArcChain::piece: s = nan");
  expect_invalid([&] { chain.closest_point({nan, 0}, ANY); }, "ArcChain::closest_point: x = nan   0");
  expect_invalid([&] { chain.closest_point({0, 0}, Param<2>(inf)); }, "ArcChain::closest_point: near = inf");
}
