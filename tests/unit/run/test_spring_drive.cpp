// A tool on a spring in whole steps: as many iterations as under a force, support without contact.
#include "support/run.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// Block 4 x 1.5, roller of radius 3 at x = 1.7 above it.
struct Block : Scene {
  explicit Block(double mu = 0.3) : Scene(block_mesh(12, 4, 2, 4, 1.5), elastic_material(), tight()) {
    add_tool(std::make_shared<Circle>(3.), std::make_shared<Cartesian>(), mu);
    place({1.7, 4.9, 0});
    tool->prescription().move("x", 1.7);
    tool->prescription().move("angle", 0);
  }
  static IterationOptions tight() {
    IterationOptions options;
    options.tolerance = 1e-9;
    return options;
  }
  long step(double t) {
    const long before = contact().iteration().counts().iterations;
    EXPECT_EQ(converge(*this, t, 1, Stepping::IMPLICIT), StepStatus::CONVERGED) << why();
    accept(*this, {});
    return contact().iteration().counts().iterations - before;
  }
  double y() { return tool->q()[1]; }
  double force() { return tool->generalized_force()[1]; }
};

} // namespace

TEST(SpringDrive, ConvergesAsUnderAForce) {
  Block spring, number;
  for (Block* block : {&spring, &number}) block->contact().approach(0, "y", block->u);
  const double y0 = spring.y();
  long with_spring = 0, with_number = 0;
  for (int i = 1; i <= 5; ++i) {
    spring.tool->force("y", "-2*(y - 4.5 + 0.05*(t + 1)) - 5*(y - 4.5)^3"); // t is the end of the step
    with_spring += spring.step(i - 1);
    const double y = spring.y();
    EXPECT_NEAR(spring.force(), -2 * (y - 4.5 + 0.05 * (i + 1)) - 5 * std::pow(y - 4.5, 3), 1e-8);
    number.tool->prescription().force("y", spring.force());
    with_number += number.step(i - 1);
    EXPECT_NEAR(number.y(), y, 1e-7 * (y0 - y));
  }
  EXPECT_LE(spring.y(), y0 - 0.02) << "pressed in";
  EXPECT_LE(with_spring, with_number + 1);
}

// The spring's place falls from above the block into it and rises again; before and after, nothing touches.
TEST(SpringDrive, HoldsTheToolWithoutContact) {
  for (const double mu : {0., 0.3}) {
    Block block(mu);
    const double rest[] = {4.7, 4.6, 4.52, 4.47, 4.44, 4.45, 4.53, 4.6};
    for (int i = 0; i < 8; ++i) {
      std::ostringstream spring;
      spring << "-3*(y - " << rest[i] << ")";
      block.tool->force("y", spring.str());
      block.step(i);
      const bool touches = i >= 3 && i <= 5;
      EXPECT_NEAR(block.force(), -3 * (block.y() - rest[i]), 1e-9);
      if (touches)
        EXPECT_LE(block.force(), -1e-3) << i;
      else
        EXPECT_NEAR(block.y(), rest[i], 1e-12) << i;
    }
  }
}

TEST(SpringDrive, StateGoesOnToTheSameBits) {
  Block a;
  a.contact().approach(0, "y", a.u);
  a.tool->force("y", "-2*(y - 4.4)");
  a.step(0);
  const auto saved = a.contact().state();
  const auto body = a.body.state();
  const Eigen::VectorXd u = a.u;
  a.step(1);
  const double y = a.y();
  a.contact().set_state(saved);
  a.body.set_state(body);
  a.u = u;
  a.step(1);
  EXPECT_EQ(a.y(), y);
}
