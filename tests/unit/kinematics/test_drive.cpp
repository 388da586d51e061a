#include "kinematics/drive.hpp"
#include "unit/finite_difference.hpp"
#include <cmath>
#include <limits>

using namespace burnish;
using namespace burnish::test;

namespace {
Drive roller() { return {"roller", {"r", "phi", "theta"}}; }
} // namespace

TEST(Drive, MotionAndForceByName) {
  Drive drive = roller();
  drive.move("phi", 0.3);
  drive.load("theta", -2e3);
  drive.load("r", 7e5);
  EXPECT_NO_THROW(drive.check_complete());
  EXPECT_FALSE(drive.is_motion(0));
  EXPECT_TRUE(drive.is_motion(1));
  EXPECT_FALSE(drive.is_motion(2));
  EXPECT_EQ(drive.value(0), 7e5);
  EXPECT_EQ(drive.value(1), 0.3);
  EXPECT_EQ(drive.value(2), -2e3);
  EXPECT_EQ(drive.size(), 3);
  EXPECT_EQ(drive.tool(), "roller");
  EXPECT_EQ(drive.names()[1], "phi");
}

TEST(Drive, LaterCallWins) {
  Drive drive = roller();
  drive.move("r", 45);
  drive.load("r", -100);
  EXPECT_FALSE(drive.is_motion(0));
  EXPECT_EQ(drive.value(0), -100);
  drive.move("r", 44);
  EXPECT_TRUE(drive.is_motion(0));
  EXPECT_EQ(drive.value(0), 44);
}

TEST(Drive, CopiesAreIndependent) {
  Drive drive = roller();
  drive.move("r", 45);
  Drive copy = drive;
  copy.load("r", 1);
  EXPECT_TRUE(drive.is_motion(0));
  EXPECT_FALSE(copy.is_motion(0));
}

TEST(Drive, RefusedCallChangesNothing) {
  Drive drive = roller();
  drive.move("r", 45);
  EXPECT_THROW(drive.load("r", std::nan("")), std::invalid_argument);
  EXPECT_TRUE(drive.is_motion(0));
  EXPECT_EQ(drive.value(0), 45);
}

TEST(Drive, IncompleteIsAnErrorNamingTheCoordinates) {
  Drive drive = roller();
  drive.load("r", 1);
  EXPECT_TRUE(drive.is_set(0));
  EXPECT_FALSE(drive.is_set(1));
  expect_invalid([&] { drive.check_complete(); },
                 "coordinate \"phi\" of tool \"roller\" has neither motion nor "
                 "force; coordinate \"theta\" of tool \"roller\" has neither");
  drive.move("theta", 0);
  expect_invalid([&] { drive.check_complete(); },
                 "Drive: coordinate \"phi\" of tool \"roller\" has neither motion nor force");
  const std::string neither = "coordinate \"phi\" of tool \"roller\" has neither motion nor force";
  expect_invalid([&] { drive.is_motion(1); }, "Drive::is_motion: " + neither);
  expect_invalid([&] { drive.value(1); }, "Drive::value: " + neither);
}

TEST(Drive, RefusesBadInput) {
  const double inf = std::numeric_limits<double>::infinity();
  Drive drive = roller();
  expect_invalid([&] { drive.move("fi", 1); },
                 "Drive::move: tool \"roller\" has no coordinate \"fi\", expected one of r, phi, theta");
  expect_invalid([&] { drive.load("x", 1); }, "Drive::load: tool \"roller\" has no coordinate \"x\"");
  expect_invalid([&] { drive.move("r", std::nan("")); },
                 "Drive::move: value of \"r\" of tool \"roller\" = nan, expected a finite number");
  expect_invalid([&] { drive.load("r", -inf); }, "Drive::load: value of \"r\" of tool \"roller\" = -inf");
  expect_invalid([&] { drive.is_set(-1); }, "Drive::is_set: k = -1, expected 0 <= k < 3 (r, phi, theta)");
  expect_invalid([&] { drive.is_motion(3); }, "Drive::is_motion: k = 3");
  expect_invalid([&] { drive.value(3); }, "Drive::value: k = 3");
  expect_invalid([] { Drive("die", {}); }, "Drive: tool \"die\" has no coordinates");
  expect_invalid([] { Drive("die", {"x", ""}); }, "Drive: tool \"die\" has a coordinate with an empty name");
  expect_invalid([] { Drive("die", {"x", "y", "x"}); }, "Drive: tool \"die\" has two coordinates \"x\"");
}
