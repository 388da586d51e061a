// Force over way of a tool: a force that has come to its largest value, a branch of falling force; and what is neither.
#include "diagnosis/step/drive_curves.hpp"
#include "diagnosis/words.hpp"
#include "geometry/segment.hpp"
#include "kinematics/cartesian.hpp"
#include "support/profile_tool.hpp"
#include "support/structured_mesh.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

enum { X, Y, ANGLE };

/// Block 4 x 1 with the spacing 0.5, a flat punch above it; its coordinates x, y, angle. Every coordinate is under motion but
/// those that are let go.
struct Press {
  ContactMesh mesh = block_mesh(8, 2, 1, 4, 1);
  ContactSetup<2> setup{mesh.space, mesh.surface, mesh.fixed, std::make_shared<EdgeMeasure>()};
  DriveCurves<2> curves;
  PrescribedValues last, next{{1, 1, 1}, Eigen::Vector3d::Zero()};
  Eigen::VectorXd q = Eigen::Vector3d(2, 1, 0), q_last = q, force = Eigen::Vector3d::Zero();
  double t = 0;

  Press() {
    const auto tool = driven_tool("punch", std::make_shared<Segment>(Vector<2>(0.5, 0), Vector<2>(-0.5, 0)),
                                  std::make_shared<Cartesian>());
    tool->place("x", 2);
    tool->place("y", 1);
    setup.add_tool(tool, make_coulomb(0.3));
    setup.close();
  }
  void let_go(int k) { next.is_motion[static_cast<std::size_t>(k)] = 0; }
  /// An accepted step to this place of coordinate k, where the force is Q.
  void step(int k, double place, double Q, double contact) {
    const Eigen::VectorXd before = q_last;
    q[k] = place;
    force[k] = Q;
    for (int c = 0; c < 3; ++c) next.value[c] = next.is_motion[static_cast<std::size_t>(c)] ? q[c] : force[c];
    curves.add(setup, {before, q, last, next, force, Eigen::VectorXd::Constant(1, contact), t += 0.1});
    last = next;
    q_last = q;
  }
  /// What is said of a step that fails with this force on y.
  std::string asked(double Q) const {
    PrescribedValues wanted = next;
    wanted.value[Y] = Q;
    return words(curves.exhausted(setup, last, wanted), setup.model());
  }
  /// Pressed down by y to the depth d in n steps under the force -f(depth); the contact force is its size, at last `gear`
  /// times as much.
  template <class Force> Press& down(const Force& f, double d, int n, double gear = 1) {
    let_go(Y);
    for (int i = 1; i <= n; ++i) {
      const double depth = d * i / n;
      step(Y, 1 - depth, -f(depth), f(depth) * (1 + (gear - 1) * i / n));
    }
    return *this;
  }
  std::string unstable() const { return curves.unstable(setup); }
};

// maximum 1 at the depth 1
double hump(double depth) { return depth * (2 - depth); }

} // namespace

// Near the top of a parabola: tool, coordinate, time, place and force are named, in numbers.
TEST(DriveCurves, ForceAtItsMaximum) {
  Press press;
  press.down(hump, 0.98, 49);
  const std::string text = press.asked(-1.1);
  EXPECT_EQ(
      text.find("nothing balances more than the force -0.9996 of coordinate \"y\" of tool \"punch\", reached "
                "at 0.02, t = 4.9: over the last 2.04082 % of its way this force has grown by 0.120048 %"),
      0U)
      << text;
  EXPECT_NE(text.find("the workpiece gives way"), std::string::npos) << text;
}

// The last step goes back by more than the part of the way that is looked at, as the tolerance of the residual allows there.
TEST(DriveCurves, MaximumWhereTheLastStepGoesBack) {
  Press press;
  press.down(hump, 0.99, 99);
  press.step(Y, 1 - 0.98, -hump(0.99) - 1e-6, 1);
  const std::string text = press.asked(-1.1);
  EXPECT_NE(text.find("over the last 1.02041 % of its way"), std::string::npos) << text;
}

// A contact force that still grows: the mechanism is the cause.
TEST(DriveCurves, DeadCenter) {
  const std::string text = Press().down(hump, 0.98, 49, 3).asked(-1.1);
  EXPECT_NE(text.find("its mechanism nears a dead center"), std::string::npos) << text;
}

TEST(DriveCurves, ForceThatStillGrows) {
  EXPECT_EQ(Press().down(hump, 0.5, 25).asked(-1.1), "");
  EXPECT_EQ(Press().down([](double d) { return std::sqrt(d); }, 1, 50).asked(-1.1), "");
  EXPECT_EQ(Press().down(hump, 0.98, 2).asked(-1.1), "") << "too few steps to know";
}

// No more force is asked, or a motion, or another drive moved the tool on.
TEST(DriveCurves, OtherCausesOfAFailure) {
  Press press;
  press.down(hump, 0.98, 49);
  EXPECT_EQ(press.asked(press.force[Y]), "");
  EXPECT_EQ(press.asked(-0.9), "");
  press.next.is_motion[Y] = 1;
  EXPECT_EQ(press.asked(-1.1), "");
  Press rolled;
  rolled.down(hump, 0.5, 25);
  for (int i = 1; i <= 10; ++i) {
    rolled.q[X] += 0.1;
    rolled.step(Y, 0.5 - 0.01 * i, -hump(0.5) - 1e-5 * i, 1);
  }
  EXPECT_EQ(rolled.asked(-1.1), "");
}

// Down the falling branch behind the maximum, more than a fifth of the spacing 0.5.
TEST(DriveCurves, FallingBranch) {
  Press press;
  for (int i = 1; i <= 12; ++i) press.step(Y, 1 - 0.1 * i, -hump(0.1 * i), 1); // by motion, over the maximum
  EXPECT_EQ(press.unstable(), "") << "under motion it is stable";
  press.let_go(Y);
  press.step(Y, -0.25, -hump(1.25), 1);
  EXPECT_EQ(press.unstable(), "") << "not far yet";
  press.step(Y, -0.35, -hump(1.35), 1);
  EXPECT_NEAR(press.curves.branch_way(), 0.15, 1e-12);
  EXPECT_EQ(
      press.unstable().find("coordinate \"y\" of tool \"punch\" goes on from -0.2 to -0.35 under a force "
                            "that falls from -0.96 to -0.8775, t = 1.2 to 1.4"),
      0U)
      << press.unstable();
  press.step(Y, -0.3, -0.5, 1);
  EXPECT_EQ(press.unstable(), "") << "it springs back";
}

// A spring as drive, a tool that something else moves: a force may fall on a stable branch.
TEST(DriveCurves, FallingForceOfAStableState) {
  const auto falls = [](bool spring, bool moved) {
    Press press;
    press.down(hump, 0.5, 25);
    if (spring)
      press.next.formula = {nullptr, force_formula("punch", "y", "-y", {"x", "y", "angle"}, {}), nullptr};
    for (int i = 1; i <= 4; ++i) {
      if (moved) press.q[X] += 0.1;
      press.step(Y, press.q[Y] - 0.1, press.force[Y] + 0.05, 1);
    }
    return press.unstable();
  };
  EXPECT_NE(falls(false, false), "");
  EXPECT_EQ(falls(true, false), "");
  EXPECT_EQ(falls(false, true), "");
}
