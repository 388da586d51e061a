// Cartesian and polar coordinates: poses, derivatives, carriers.
#include "kinematics/cartesian.hpp"
#include "kinematics/polar.hpp"
#include "unit/kinematics/pose_derivatives.hpp"
#include <cmath>

using namespace burnish;
using namespace burnish::test;
using Eigen::Vector3d;

namespace {
const Vector<2> PIVOT(0.4, -0.7);
const Vector3d POSES[] = {{1, 0, 0}, {1.5, 0.3, -2}, {0.8, -4, 9}, {0, 1, 1}, {-1, 2, 0.1}};
} // namespace

TEST(Coordinates, DerivativesAgainstFiniteDifferences) {
  for (const Vector3d& q : POSES) {
    check_pose_derivatives(Cartesian(), q);
    check_pose_derivatives(Polar(PIVOT), q);
  }
}

TEST(Coordinates, NamesAndPoses) {
  EXPECT_EQ(Cartesian().names(), (std::vector<std::string>{"x", "y", "angle"}));
  EXPECT_EQ(Polar().names(), (std::vector<std::string>{"r", "phi", "theta"}));
  EXPECT_EQ(Polar().size(), 3);
  const Pose<2> cartesian = Cartesian().pose(Vector3d(3, 4, M_PI_2));
  expect_close(cartesian.origin, Vector<2>(3, 4), 1, 0, "origin");
  expect_close(cartesian.R * Vector<2>(1, 0), Vector<2>(0, 1), 1, 1e-15, "R (1,0)");
  const Pose<2> polar = Polar(PIVOT).pose(Vector3d(2, M_PI_2, 0));
  expect_close(polar.origin, Vector<2>(0.4, 1.3), 1, 1e-15, "origin: phi turns the position");
  expect_close(polar.R, Tensor<2>::Identity(), 1, 0, "R: phi does not turn the frame");
}

TEST(Coordinates, CartesianCarrierIsTheTranslation) {
  const RigidMotion<2> carrier = Cartesian().carrier(Vector3d(1, 2, 0), Vector3d(4, 0, 2));
  expect_close(carrier({10, 10}), Vector<2>(13, 8), 1, 1e-15, "carried point");
  expect_close(carrier.R, Tensor<2>::Identity(), 1, 0, "R");
}

TEST(Coordinates, PolarCarrierIsTheTurnAboutThePivot) {
  const Polar polar(PIVOT);
  for (const Vector3d& from : POSES)
    for (const Vector3d& to : POSES) {
      const RigidMotion<2> carrier = polar.carrier(from, to);
      expect_close(carrier(PIVOT), PIVOT, 1, 1e-15, "pivot");
      // r and theta are not part of it
      const Vector<2> expected = polar.pose(Vector3d(from(0), to(1), 0)).origin;
      expect_close(carrier(polar.pose(from).origin), expected, 1, 1e-14, "carried origin");
      expect_close(carrier.inverse()(carrier({5, 6})), Vector<2>(5, 6), 5, 1e-14, "there and back");
    }
}

TEST(Coordinates, SameInMetersAndMillimeters) {
  const Pose<2> in_m = Polar(1e-3 * PIVOT).pose(Vector3d(45e-3, 1, 2));
  const Pose<2> in_mm = Polar(PIVOT).pose(Vector3d(45, 1, 2));
  expect_close(1000 * in_m.origin, in_mm.origin, 45, 1e-15, "origin");
  expect_close(in_m.origin_q[0], in_mm.origin_q[0], 1, 1e-15, "origin_r");
  expect_close(1000 * in_m.origin_q[1], in_mm.origin_q[1], 45, 1e-15, "origin_phi");
  const RigidMotion<2> m = Polar(1e-3 * PIVOT).carrier(Vector3d(45e-3, 1, 2), Vector3d(46e-3, 2, 2));
  const RigidMotion<2> mm = Polar(PIVOT).carrier(Vector3d(45, 1, 2), Vector3d(46, 2, 2));
  expect_close(1000 * m.d, mm.d, 1, 1e-14, "carrier d");
}

TEST(Coordinates, RefuseBadInput) {
  const double nan = std::nan("");
  const Eigen::VectorXd two = Eigen::VectorXd::Zero(2), good = Vector3d(1, 0, 0), bad = Vector3d(1, nan, 0);
  expect_invalid([&] { Cartesian().pose(two); }, "Cartesian::pose: size of q = 2, expected 3 (x, y, angle)");
  expect_invalid([&] { Cartesian().pose(bad); }, "Cartesian::pose: y = nan, expected a finite number");
  expect_invalid([&] { Cartesian().carrier(good, bad); }, "Cartesian::pose: y = nan");
  expect_invalid([&] { Polar().pose(two); }, "Polar::pose: size of q = 2, expected 3 (r, phi, theta)");
  expect_invalid([&] { Polar().pose(bad); }, "Polar::pose: phi = nan");
  expect_invalid([&] { Polar().carrier(two, good); }, "Polar::carrier: size of q = 2");
  expect_invalid([&] { Polar().carrier(good, bad); }, "Polar::carrier: phi = nan");
  expect_invalid([&] { Polar({nan, 0}); }, "Polar: pivot = nan   0, expected finite components");
}
