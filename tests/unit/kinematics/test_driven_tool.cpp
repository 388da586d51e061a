// A tool with what is prescribed for it and its place, as runs and scripts use it.
#include "geometry/circle.hpp"
#include "kinematics/polar.hpp"
#include "support/profile_tool.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

TEST(DrivenTool, PlaceDriveAndForce) {
  DrivenTool<2> roller("roller", std::make_shared<ProfileSurface>(std::make_shared<Circle>(2.)));
  roller.set_coordinates(std::make_shared<Polar>());
  EXPECT_EQ(roller.q(), Eigen::VectorXd::Zero(3));
  EXPECT_EQ(roller.generalized_force(), Eigen::VectorXd::Zero(3));
  EXPECT_EQ(roller.index("r"), 0);
  EXPECT_EQ(roller.index("theta"), 2);
  roller.place("phi", 0.4);
  EXPECT_EQ(roller.q()[1], 0.4);
  roller.prescription().force("r", -3);
  EXPECT_EQ(roller.prescription().value(0), -3);
  EXPECT_EQ(roller.shared_tool()->name(), "roller");
  roller.set_coordinates(std::make_shared<Polar>(Vector<2>(1, 0))); // forgets place and program
  EXPECT_EQ(roller.q()[1], 0);
  EXPECT_FALSE(roller.prescription().is_set(0));
}

TEST(DrivenTool, BadInput) {
  const auto circle = std::make_shared<ProfileSurface>(std::make_shared<Circle>(2.));
  expect_invalid([&] { DrivenTool<2>("", circle); }, "tool: the name is empty");
  expect_invalid([&] { DrivenTool<2>("roller", nullptr); }, "tool: no surface");
  DrivenTool<2> roller("roller", circle);
  const std::string early = "tool: \"roller\" has no coordinates yet: call coordinates(...) first";
  expect_invalid([&] { roller.tool(); }, early);
  expect_invalid([&] { roller.prescription(); }, early);
  expect_invalid([&] { roller.q(); }, early);
  expect_invalid([&] { roller.generalized_force(); }, early);
  expect_invalid([&] { roller.place("r", 1); }, early);
  roller.set_coordinates(std::make_shared<Polar>());
  expect_invalid([&] { roller.index("x"); },
                 "tool: \"roller\" has no coordinate \"x\", its coordinates are r, phi, theta");
  expect_invalid([&] { roller.place("x", 1); }, "its coordinates are r, phi, theta");
  expect_invalid([&] { roller.place("r", std::nan("")); }, "tool.place: r = nan, expected a finite number");
}
