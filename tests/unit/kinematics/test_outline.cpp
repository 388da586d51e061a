#include "geometry/arc_chain.hpp"
#include "geometry/circle.hpp"
#include "geometry/segment.hpp"
#include "kinematics/cartesian.hpp"
#include "kinematics/outline.hpp"
#include "support/profile_tool.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

template <class Shape> Tool<2> tool_of(Shape shape) {
  return *profile_tool("tool", std::make_shared<Shape>(std::move(shape)), std::make_shared<Cartesian>());
}
const Eigen::Vector3d PLACE(2, -1, 0.3);

} // namespace

TEST(Outline, CircleIsClosedAndUniform) {
  const auto points = outline(tool_of(Circle(0.5)), PLACE, 7);
  ASSERT_EQ(points.size(), 7u);
  expect_close(points.front(), points.back(), 1, 1e-15, "closed");
  for (std::size_t i = 0; i < 7; ++i) {
    const double angle = 0.3 + 2 * M_PI * static_cast<double>(i) / 6;
    expect_close(points[i], Vector<2>(2 + 0.5 * std::cos(angle), -1 + 0.5 * std::sin(angle)), 1, 1e-15,
                 "point");
  }
}

TEST(Outline, SegmentHasItsEnds) {
  const auto points = outline(tool_of(Segment({0, 0}, {4, 0})), Eigen::Vector3d(1, 2, M_PI / 2), 2);
  ASSERT_EQ(points.size(), 2u);
  expect_close(points[0], Vector<2>(1, 2), 1, 1e-15, "a");
  expect_close(points[1], Vector<2>(1, 6), 1, 1e-15, "b");
}

// Every joint is there, in order, however few points are asked for.
TEST(Outline, ArcChainHasItsJoints) {
  const ArcChain open({{-4, 3}, {-4, 0}, {1, 0}, {1.5, 2}}, {0, 0.8, 0.4, 0}),
      closed({{0, 0}, {4, 0}, {4, 2}, {0, 2}}, {0.5, 0.5, 0.25, 0.5}, true);
  for (const ArcChain* chain : {&open, &closed})
    for (long n : {2, 3, 50}) {
      const auto points = outline(tool_of(*chain), Eigen::Vector3d::Zero(), n);
      EXPECT_EQ(points.size(), static_cast<std::size_t>(n) + chain->pieces().size() - 1);
      std::size_t at = 0;
      for (const ArcPiece& piece : chain->pieces()) {
        while (at < points.size() && (points[at] - piece.start).norm() > 1e-12) ++at;
        EXPECT_LT(at, points.size()) << "joint at " << piece.start.transpose();
      }
      const double L = chain->length();
      expect_close(points.back(), chain->evaluate(Param<2>(L)).x, 1, 1e-15, "end");
    }
}

TEST(Outline, RefusesBadInput) {
  const Tool<2> tool = tool_of(Circle(1));
  expect_invalid([&] { outline(tool, PLACE, 1); }, "outline: number of points = 1, expected 2 to 1000000");
  expect_invalid([&] { outline(tool, Eigen::Vector2d(0, 0), 5); }, "Cartesian::pose");
}
