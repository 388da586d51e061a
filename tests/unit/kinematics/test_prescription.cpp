#include "kinematics/prescription.hpp"
#include "unit/finite_difference.hpp"
#include <cmath>
#include <limits>

using namespace burnish;
using namespace burnish::test;

namespace {
Prescription roller() { return {"roller", {"r", "phi", "theta"}}; }
} // namespace

TEST(Prescription, MotionAndForceByName) {
  Prescription prescription = roller();
  prescription.move("phi", 0.3);
  prescription.force("theta", -2e3);
  prescription.force("r", 7e5);
  EXPECT_NO_THROW(prescription.check_complete());
  EXPECT_FALSE(prescription.is_motion(0));
  EXPECT_TRUE(prescription.is_motion(1));
  EXPECT_FALSE(prescription.is_motion(2));
  EXPECT_EQ(prescription.value(0), 7e5);
  EXPECT_EQ(prescription.value(1), 0.3);
  EXPECT_EQ(prescription.value(2), -2e3);
  EXPECT_EQ(prescription.size(), 3);
  EXPECT_EQ(prescription.tool(), "roller");
  EXPECT_EQ(prescription.names()[1], "phi");
}

TEST(Prescription, LaterCallWins) {
  Prescription prescription = roller();
  prescription.move("r", 45);
  prescription.force("r", -100);
  EXPECT_FALSE(prescription.is_motion(0));
  EXPECT_EQ(prescription.value(0), -100);
  prescription.move("r", 44);
  EXPECT_TRUE(prescription.is_motion(0));
  EXPECT_EQ(prescription.value(0), 44);
}

TEST(Prescription, CopiesAreIndependent) {
  Prescription prescription = roller();
  prescription.move("r", 45);
  Prescription copy = prescription;
  copy.force("r", 1);
  EXPECT_TRUE(prescription.is_motion(0));
  EXPECT_FALSE(copy.is_motion(0));
}

TEST(Prescription, RefusedCallChangesNothing) {
  Prescription prescription = roller();
  prescription.move("r", 45);
  EXPECT_THROW(prescription.force("r", std::nan("")), std::invalid_argument);
  EXPECT_TRUE(prescription.is_motion(0));
  EXPECT_EQ(prescription.value(0), 45);
}

TEST(Prescription, IncompleteIsAnErrorNamingTheCoordinates) {
  Prescription prescription = roller();
  prescription.force("r", 1);
  EXPECT_TRUE(prescription.is_set(0));
  EXPECT_FALSE(prescription.is_set(1));
  expect_invalid([&] { prescription.check_complete(); },
                 "coordinate \"phi\" of tool \"roller\" has neither motion nor "
                 "force; coordinate \"theta\" of tool \"roller\" has neither");
  prescription.move("theta", 0);
  expect_invalid([&] { prescription.check_complete(); },
                 "Prescription: coordinate \"phi\" of tool \"roller\" has neither motion nor force");
  const std::string neither = "coordinate \"phi\" of tool \"roller\" has neither motion nor force";
  expect_invalid([&] { prescription.is_motion(1); }, "Prescription::is_motion: " + neither);
  expect_invalid([&] { prescription.value(1); }, "Prescription::value: " + neither);
}

TEST(Prescription, RefusesBadInput) {
  const double inf = std::numeric_limits<double>::infinity();
  Prescription prescription = roller();
  expect_invalid(
      [&] { prescription.move("fi", 1); },
      "Prescription::move: tool \"roller\" has no coordinate \"fi\", expected one of r, phi, theta");
  expect_invalid([&] { prescription.force("x", 1); },
                 "Prescription::force: tool \"roller\" has no coordinate \"x\"");
  expect_invalid([&] { prescription.move("r", std::nan("")); },
                 "Prescription::move: value of \"r\" of tool \"roller\" = nan, expected a finite number");
  expect_invalid([&] { prescription.force("r", -inf); },
                 "Prescription::force: value of \"r\" of tool \"roller\" = -inf");
  expect_invalid([&] { prescription.is_set(-1); },
                 "Prescription::is_set: k = -1, expected 0 <= k < 3 (r, phi, theta)");
  expect_invalid([&] { prescription.is_motion(3); }, "Prescription::is_motion: k = 3");
  expect_invalid([&] { prescription.value(3); }, "Prescription::value: k = 3");
  expect_invalid([] { Prescription("die", {}); }, "Prescription: tool \"die\" has no coordinates");
  expect_invalid(
      [] {
        Prescription("die", {"x", ""});
      },
      "Prescription: tool \"die\" has a coordinate with an empty name");
  expect_invalid(
      [] {
        Prescription("die", {"x", "y", "x"});
      },
      "Prescription: tool \"die\" has two coordinates \"x\"");
}
