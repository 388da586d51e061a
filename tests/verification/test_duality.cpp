// Prescribe q(t) and read Q(t); prescribe that Q(t) and recover q(t). Elastic block, tools with friction.
#include "support/rolled_block.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

const Vector<2> PIVOT(2.2, -3);
using Path = std::function<Vector<3>(int step)>;

/// Position and angle of a flat punch, wider than the block: pressed in, tilting, pushed sideways until it
/// slides.
Vector<3> punch_path(int step) {
  return {2 + 0.001 * std::max(0, step - 6), 1.54 - 0.01 * step, 0.02 - 0.0012 * step};
}

std::shared_ptr<const Profile<2>> roller() { return std::make_shared<Circle>(3.); }
std::shared_ptr<const Profile<2>> punch() {
  return std::make_shared<Segment>(Vector<2>(4, 0), Vector<2>(-4, 0));
}

/// Runs under motion, then once more with the coordinates of `loaded` under the forces that were read, from
/// the second step on: the one node that touches at the start cannot hold three coordinates.
void check_duality(std::shared_ptr<const Profile<2>> profile,
                   std::shared_ptr<const Coordinates<2>> coordinates, const Path& path,
                   const std::vector<int>& loaded) {
  RolledBlock moved(profile, coordinates, 0.3), driven(profile, coordinates, 0.3);
  const auto& names = coordinates->names();
  for (RolledBlock* block : {&moved, &driven}) {
    const Vector<3> start = path(0);
    block->scene.place({start[0], start[1], start[2]});
    block->scene.contact().approach(0, names[names[0] == "x"], block->scene.u);
  }
  moved.run([&](int k) { moved.move(path(k)); });
  driven.run([&](int k) {
    driven.move(path(k));
    if (k == 1) return;
    for (const int c : loaded) driven.scene.tool->prescription().force(names[c], moved.force[k - 1][c]);
  });
  if (testing::Test::HasFatalFailure()) return;
  double worst = 0;
  for (int k = 0; k < RolledBlock::STEPS; ++k) {
    worst = std::max(worst, (driven.q[k] - path(k + 1)).cwiseAbs().maxCoeff());
    for (const int c : loaded) EXPECT_NEAR(driven.force[k][c], moved.force[k][c], 1e-9) << "step " << k;
  }
  EXPECT_LE(worst, 1e-9) << "of paths of 0.1 and more";
  EXPECT_GE((path(RolledBlock::STEPS) - path(0)).cwiseAbs().maxCoeff(), 0.1);
  for (const int c : loaded) EXPECT_GE(std::abs(moved.force.back()[c]), 5e-3) << "no force, no test";
  std::cout << "q recovered to " << worst << "\n";
  expect_same_displacement(
      moved, [&](int k) { return driven.u[k]; }, 1e-9);
}

Vector<3> polar_roller(int k) { return polar_place(roller_path(k), PIVOT); }
Vector<3> polar_punch(int k) { return polar_place(punch_path(k), PIVOT); }

} // namespace

TEST(Duality, PunchCartesianAllUnderForce) {
  check_duality(punch(), std::make_shared<Cartesian>(), punch_path, {0, 1, 2});
}

TEST(Duality, PunchPolarAllUnderForce) {
  check_duality(punch(), std::make_shared<Polar>(PIVOT), polar_punch, {0, 1, 2});
}

// A roller under a dead load and a torque is in neutral equilibrium along its way: one coordinate is moved.
TEST(Duality, RollerCartesian) {
  for (const auto& loaded : std::vector<std::vector<int>>{{0}, {1}, {2}, {0, 1}, {1, 2}})
    check_duality(roller(), std::make_shared<Cartesian>(), roller_path, loaded);
}

TEST(Duality, RollerPolar) {
  for (const auto& loaded : std::vector<std::vector<int>>{{0}, {1}, {2}, {0, 1}, {0, 2}})
    check_duality(roller(), std::make_shared<Polar>(PIVOT), polar_roller, loaded);
}
