// The nodal solution does not depend on how the tool is described: Cartesian or polar coordinates,
// another pivot, a turned frame, another reference point of the tool.
#include "support/rolled_block.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

const double MU = 0.3;

std::shared_ptr<const Profile<2>> circle() { return std::make_shared<Circle>(3.); }

/// Along the path in Cartesian coordinates, everything turned by `turn` about the origin.
std::unique_ptr<RolledBlock> cartesian(double turn = 0) {
  auto block = std::make_unique<RolledBlock>(circle(), std::make_shared<Cartesian>(), MU, turn);
  const auto place = [turn](int k) {
    Vector<3> q = roller_path(k);
    q.head<2>() = plane_rotation(turn) * q.head<2>();
    return Vector<3>(q + turn * Vector<3>::UnitZ());
  };
  const Vector<3> start = place(0);
  block->scene.place({start[0], start[1], start[2]});
  block->run([&](int k) { block->move(place(k)); });
  return block;
}

std::unique_ptr<RolledBlock> polar(const Vector<2>& pivot) {
  auto block = std::make_unique<RolledBlock>(circle(), std::make_shared<Polar>(pivot), MU);
  const Vector<3> start = polar_place(roller_path(0), pivot);
  block->scene.place({start[0], start[1], start[2]});
  block->run([&](int k) { block->move(polar_place(roller_path(k), pivot)); });
  return block;
}

} // namespace

TEST(Invariance, PolarAgainstCartesian) {
  const auto a = cartesian(), b = polar(Vector<2>(2.2, -3));
  ASSERT_FALSE(HasFatalFailure());
  expect_same_displacement(
      *a, [&](int k) { return b->u[k]; }, 1e-9);
  // forces: Q_r = F . e, Q_phi = r F . e'
  for (int k = 0; k < RolledBlock::STEPS; ++k) {
    const Vector<2> e = plane_direction(b->q[k][1]), F = a->force[k].head<2>();
    EXPECT_NEAR(b->force[k][0], e.dot(F), 1e-9);
    EXPECT_NEAR(b->force[k][1], b->q[k][0] * left_of(e).dot(F), 1e-8);
    EXPECT_NEAR(b->force[k][2], a->force[k][2], 1e-9);
  }
}

TEST(Invariance, MovedPivot) {
  const auto a = polar(Vector<2>(2.2, -3)), b = polar(Vector<2>(-6, 11));
  ASSERT_FALSE(HasFatalFailure());
  expect_same_displacement(
      *a, [&](int k) { return b->u[k]; }, 1e-9);
}

TEST(Invariance, TurnedFrame) {
  const double turn = 0.7;
  const auto a = cartesian(), b = cartesian(turn);
  ASSERT_FALSE(HasFatalFailure());
  const Tensor<2> back = plane_rotation(-turn);
  expect_same_displacement(
      *a,
      [&](int k) {
        Eigen::VectorXd u = b->u[k];
        for (Eigen::Index n = 0; n < u.size(); n += 2) u.segment<2>(n) = (back * u.segment<2>(n)).eval();
        return u;
      },
      1e-9);
}

// Pressing force and torque: y, angle of a Cartesian tool; r, theta of a polar one straight above its pivot.
TEST(Invariance, UnderForce) {
  const auto press = [](std::shared_ptr<const Coordinates<2>> coordinates, const Vector<3>& start,
                        const std::string& down) {
    auto block = std::make_unique<RolledBlock>(circle(), std::move(coordinates), MU);
    block->scene.place({start[0], start[1], start[2]});
    block->scene.contact().approach(0, down, block->scene.u);
    auto& prescription = block->scene.tool->prescription();
    const std::string other = down == "y" ? "x" : "phi", spin = down == "y" ? "angle" : "theta";
    block->run([&](int k) {
      prescription.force(down, -0.015 * k);
      prescription.force(spin, 0.01 * k * MU);
      prescription.move(other, start[down == "y" ? 0 : 1]);
    });
    return block;
  };
  const auto a = press(std::make_shared<Cartesian>(), {1.7, 4.6, 0.1}, "y");
  const auto b = press(std::make_shared<Polar>(Vector<2>(1.7, -2)), {6.6, M_PI / 2, 0.1}, "r");
  ASSERT_FALSE(HasFatalFailure());
  expect_same_displacement(
      *a, [&](int k) { return b->u[k]; }, 1e-9);
  EXPECT_NEAR(a->q.back()[1] + 2, b->q.back()[0], 1e-9);
  EXPECT_NEAR(a->q.back()[2], b->q.back()[2], 1e-9);
}

// A tilting punch, wider than the block, described about two points of its frame.
TEST(Invariance, MovedReferencePoint) {
  const auto press = [](const Vector<2>& reference) {
    const Vector<2> a(4, 0), b(-4, 0);
    auto block = std::make_unique<RolledBlock>(std::make_shared<Segment>(a - reference, b - reference),
                                               std::make_shared<Cartesian>(), MU);
    const auto place = [&](int k) {
      const double angle = 0.02 - 0.001 * k;
      const Vector<2> origin = Vector<2>(2, 1.6 - 0.01 * k) + plane_rotation(angle) * reference;
      return Vector<3>(origin.x(), origin.y(), angle);
    };
    const Vector<3> start = place(0);
    block->scene.place({start[0], start[1], start[2]});
    block->run([&](int k) { block->move(place(k)); });
    return block;
  };
  const Vector<2> reference(1.3, 0.8);
  const auto a = press(Vector<2>::Zero()), b = press(reference);
  ASSERT_FALSE(HasFatalFailure());
  expect_same_displacement(
      *a, [&](int k) { return b->u[k]; }, 1e-9);
  const Vector<3> Q = a->force.back(), P = b->force.back();
  EXPECT_LE((Q - P).head<2>().norm(), 1e-9);
  const Vector<2> arm = plane_rotation(a->q.back()[2]) * reference;
  EXPECT_NEAR(P[2], Q[2] - (arm.x() * Q[1] - arm.y() * Q[0]), 1e-9) << "moment about the other point";
}
