#include "geometry/arc_chain.hpp"
#include "geometry/circle.hpp"
#include "kinematics/cartesian.hpp"
#include "kinematics/window_outline.hpp"
#include "support/profile_tool.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

const Eigen::Vector3d PLACE(2, 11, 0.3);

PictureWindow<2> unit_window() {
  Eigen::VectorXd places(4);
  places << 0, 0, 4, 1;
  return picture_window<2>(places);
}

} // namespace

TEST(WindowOutline, WindowRoundThePlaces) {
  const auto window = unit_window();
  expect_close(window.low, Vector<2>(-2, -2), 1, 1e-15, "low");
  expect_close(window.high, Vector<2>(6, 3), 1, 1e-15, "high");
  EXPECT_NEAR(window.sagitta, 8e-4, 1e-15);
}

// A large roller: a line of pixels where it is seen, few points elsewhere.
TEST(WindowOutline, CircleIsFineWhereItIsSeen) {
  const double R = 10;
  const auto window = unit_window();
  const auto points = window_outline(
      *profile_tool("roller", std::make_shared<Circle>(R), std::make_shared<Cartesian>()), PLACE, window);
  ASSERT_GT(points.size(), 64u);
  EXPECT_LT(points.size(), 400u);
  expect_close(points.front(), points.back(), 1, 1e-13, "closed");
  int seen = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vector<2> middle = 0.5 * (points[i] + points[i - 1]), center(2, 11);
    const double off = R - (middle - center).norm();
    EXPECT_LT(off, window.sagitta * FAR_OUT);
    if (middle[1] > window.high[1] || std::abs(middle[0] - 2) > 3) continue;
    EXPECT_LT(off, window.sagitta);
    ++seen;
  }
  EXPECT_GT(seen, 20);
}

// Teeth that are shorter than the first intervals: each has its tip and its foot.
TEST(WindowOutline, NoToothIsCut) {
  const int teeth = 150;
  std::vector<Vector<2>> corners;
  std::vector<double> fillets;
  for (int k = 0; k < 2 * teeth; ++k) {
    const double a = M_PI * k / teeth, r = k % 2 == 0 ? 10 : 9.8;
    corners.emplace_back(r * std::cos(a), r * std::sin(a));
    fillets.push_back(0.03);
  }
  const auto wheel = std::make_shared<ArcChain>(corners, fillets, true);
  const auto points =
      window_outline(*profile_tool("wheel", wheel, std::make_shared<Cartesian>()), PLACE, unit_window());
  for (const ArcPiece& piece : wheel->pieces()) {
    double nearest = 1;
    const Vector<2> start = PLACE.head<2>() + Eigen::Rotation2Dd(PLACE[2]) * Vector<2>(piece.start);
    for (const auto& p : points) nearest = std::min(nearest, (p - start).norm());
    EXPECT_LT(nearest, 1e-9);
  }
}

TEST(WindowOutline, RefusesBadInput) {
  const auto tool = profile_tool("roller", std::make_shared<Circle>(1), std::make_shared<Cartesian>());
  PictureWindow<2> window = unit_window();
  window.sagitta = 0;
  expect_invalid([&] { window_outline(*tool, PLACE, window); }, "outline: sagitta = 0, expected > 0");
}
