// The verbs of a step loop on a small elastic block under a roller.
#include "geometry/arc_chain.hpp"
#include "support/run.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// Block 4 x 1.5, roller of radius 3 at x = 1.7 above it.
struct Block : Scene {
  explicit Block(double mu = 0.3, const IterationOptions& options = {})
      : Scene(block_mesh(12, 4, 2, 4, 1.5), elastic_material(), options) {
    add_tool(std::make_shared<Circle>(3.), std::make_shared<Cartesian>(), mu);
    place({1.7, 4.9, 0});
  }
  void drive(double x, double y, double angle) {
    tool->prescription().move("x", x);
    tool->prescription().move("y", y);
    tool->prescription().move("angle", angle);
  }
  void step(double dt = 1, Stepping stepping = Stepping::IMPLICIT) {
    ASSERT_EQ(converge(*this, 0, dt, stepping), StepStatus::CONVERGED) << why();
    accept(*this, {});
  }
  int count(NodeState state) {
    int number = 0;
    for (const auto& node : contact().accepted().contact.nodes) number += node.state == state;
    return number;
  }
};

} // namespace

TEST(ContactRun, CandidatesAreTheFreeNodesOfTheSurface) {
  const auto mesh = block_mesh(3, 2, 2, 3, 1);
  auto fixed = mesh.fixed;
  const int left = mesh.surface[0].vertex[1], right = mesh.surface[2].vertex[0];
  fixed[2 * left] = fixed[2 * left + 1] = 1;
  fixed[2 * right] = 1; // held in one direction only: still a candidate
  const ContactSetup<2> setup(mesh.space, mesh.surface, fixed, std::make_shared<EdgeMeasure>());
  EXPECT_EQ(setup.candidates().size(), 6u);
  EXPECT_EQ(setup.candidates().front(), mesh.surface[0].middle[0]);
  EXPECT_EQ(setup.candidates().back(), right);
}

// The roller comes down on the flat top: the node nearest to x = 1.7 is at 10/6.
TEST(ContactRun, ApproachTouchesTheNearestNode) {
  for (const double height : {4.9, 3.5}) { // from outside and from inside
    Block block;
    block.place({1.7, height, 0});
    const double y = block.contact().approach(0, "y", block.u), offset = 1.7 - 10. / 6;
    EXPECT_NEAR(y, 1.5 + std::sqrt(9 - offset * offset), 1e-9);
    EXPECT_EQ(block.tool->q()[1], y);
    EXPECT_EQ(block.count(NodeState::STICKING), 1);
  }
  Block smooth(0);
  smooth.contact().approach(0, "y", smooth.u);
  EXPECT_EQ(smooth.count(NodeState::SLIDING), 1);
}

TEST(ContactRun, ApproachOfAFlatPunchTouchesAllNodes) {
  const auto mesh = block_mesh(12, 4, 2, 4, 1.5);
  Scene scene(mesh, elastic_material());
  scene.add_tool(std::make_shared<Segment>(Vector<2>(4, 0), Vector<2>(-4, 0)), std::make_shared<Cartesian>(),
                 0.3);
  scene.place({2, 3, 0});
  EXPECT_NEAR(scene.contact().approach(0, "y", scene.u), 1.5, 1e-9);
  int touching = 0;
  for (const auto& node : scene.contact().accepted().contact.nodes)
    touching += node.state == NodeState::STICKING;
  EXPECT_EQ(touching, 25);
}

// A stepped tool is pushed along the top: its lower side slides 0.1 above it all the way, its riser, 1 behind its origin, meets
// the corner at x = 0 first.
TEST(ContactRun, ApproachAlongTheNearestNodesFindsTheFirstTouch) {
  const auto mesh = block_mesh(12, 4, 2, 4, 1.5);
  for (const double x : {0., 0.7, -3.}) {
    Scene scene(mesh, elastic_material());
    const std::vector<Vector<2>> corners{{9, 0}, {-1, 0}, {-1, -1}};
    scene.add_tool(std::make_shared<ArcChain>(corners, std::vector<double>{0, 0.05, 0}),
                   std::make_shared<Cartesian>(), 0.3);
    scene.place({x, 1.6, 0});
    EXPECT_NEAR(scene.contact().approach(0, "x", scene.u), 1, 1e-9) << x;
  }
}

TEST(ContactRun, AcceptUpdatesToolStateAndLog) {
  Block block;
  block.drive(1.7, 4.45, 0);
  block.step();
  const auto& state = block.contact().accepted().contact;
  EXPECT_NEAR(block.tool->q()[1], 4.45, 1e-15);
  EXPECT_LE(block.tool->generalized_force()[1], -1e-3) << "the drive presses";
  EXPECT_EQ(block.tool->generalized_force(), block.contact().iteration().balance().last().generalized_force);
  const int contact = block.count(NodeState::STICKING) + block.count(NodeState::SLIDING);
  EXPECT_GE(contact, 3);
  EXPECT_EQ(static_cast<int>(block.contact().accepted().log.events.size()), contact) << "one touch for each";
  for (const auto& event : block.contact().accepted().log.events) EXPECT_STREQ(name_of(event.kind), "touch");
  EXPECT_EQ(block.contact().accepted().u, block.u);
  EXPECT_EQ(block.contact().accepted().R, block.R);
  std::vector<Vector<2>> x;
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
    if (in_contact(state.nodes[i].state))
      x.push_back(block.contact().setup().body().position(block.u, block.setup->candidates()[i]));
  EXPECT_NEAR(contact_width(block.contact()), (x.back() - x.front()).norm(), 1e-14);
}

// A roller that goes sideways by 0.2 in dt = 0.5: the contact travels at 0.4.
TEST(ContactRun, ContactSpeed) {
  Block block;
  EXPECT_EQ(contact_speed(block.contact()), 0);
  EXPECT_EQ(contact_width(block.contact()), 0);
  block.drive(1.7, 4.42, 0);
  block.step();
  block.drive(1.9, 4.42, -0.2 / 3);
  block.step(0.5);
  EXPECT_NEAR(contact_speed(block.contact()), 0.4, 0.4 * 0.02);
}

TEST(ContactRun, RevertedStepLeavesNoTrace) {
  const auto run = [](bool detour) {
    Block block;
    block.contact().approach(0, "y", block.u);
    for (const double y : {4.47, 4.45}) {
      block.drive(1.7, y, 0);
      block.step();
    }
    const double accepted_scale = block.contact().iteration().balance().memory().scale;
    if (detour) {
      const Eigen::VectorXd accepted = block.u;
      block.drive(1.8, 4.4, -0.03);
      EXPECT_EQ(converge(block, 1, 1, Stepping::IMPLICIT), StepStatus::CONVERGED);
      EXPECT_GE((block.u - accepted).norm(), 0.05);
      EXPECT_GE(block.contact().iteration().balance().memory().scale, 1.5 * accepted_scale);
      revert(block);
      EXPECT_NEAR(block.contact().iteration().state().q[1], 4.45, 1e-15);
      EXPECT_NEAR(block.tool->q()[1], 4.45, 1e-15);
    }
    const double scale = block.contact().iteration().balance().memory().scale;
    block.drive(1.75, 4.43, 0);
    block.step();
    return std::make_pair(block.u, scale);
  };
  const auto straight = run(false), detour = run(true);
  EXPECT_EQ(straight.second, detour.second) << "the load of the reverted step does not loosen the tolerance";
  EXPECT_EQ(straight.first, detour.first);
}

// The same step by the condensed sparse matrix and UMFPACK: a full Newton method in nodes, slips,
// coordinates.
TEST(ContactRun, CondensedSystemSolvesTheSameStep) {
  IterationOptions options;
  options.tolerance = 1e-11;
  Block block(0.3, options);
  block.drive(1.7, 4.45, 0);
  block.step();
  block.drive(1.72, 4.449, 0.02);
  ASSERT_EQ(converge(block, 1, 1, Stepping::EVENT), StepStatus::CONVERGED); // the states stay
  const Eigen::VectorXd expected = block.u;
  revert(block);
  block.contact().begin(block.u, 1, 1, Stepping::EVENT);
  UnsymmetricSolver solver;
  for (int it = 0; it < 8; ++it) {
    ASSERT_EQ(block.workpiece().update(block.u, 1, it).status, UpdateStatus::OK);
    block.workpiece().tangent(block.tangent, TangentKind::CONSISTENT);
    const auto& system =
        block.contact().condensed().condense(block.tangent, block.u, block.workpiece().internal_force(),
                                             GeometricTerms::COMPLETE, RightHandSide::TOTAL, false);
    ASSERT_EQ(
        solver.factorize({system.n, system.row_start.data(), system.col.data(), system.value.data(), false}),
        FactorStatus::OK);
    const double increment = block.contact().condensed().expand(solver.solve(system.rhs), block.u);
    if (it == 7) {
      EXPECT_LE(increment, 1e-12);
    }
  }
  EXPECT_LE((block.u - expected).cwiseAbs().maxCoeff(), 1e-9 * expected.cwiseAbs().maxCoeff());
}

// Without friction nothing resists the rotation of a circle: under zero torque it is left out and reported.
TEST(ContactRun, CoordinatesThatNothingResistsAreLeftOut) {
  Block block(0);
  block.contact().approach(0, "y", block.u);
  block.drive(1.7, 4.45, 0);
  block.tool->prescription().force("angle", 0);
  block.step();
  block.drive(1.7, 4.44, 0);
  block.tool->prescription().force("angle", 0);
  block.step();
  ASSERT_EQ(left_out(block.contact()).size(), 1u) << "named once";
  EXPECT_EQ(left_out(block.contact())[0], "coordinate \"angle\" of tool \"tool\"");
  EXPECT_EQ(block.tool->q()[2], 0);
}

TEST(ContactRun, ControlMayChangeFromMotionToForce) {
  Block block;
  block.contact().approach(0, "y", block.u);
  for (const double y : {4.47, 4.45}) {
    block.drive(1.7, y, 0);
    block.step();
  }
  const double target = 1.2 * block.tool->generalized_force()[1];
  block.tool->prescription().force("y", target);
  block.step();
  EXPECT_NEAR(block.tool->generalized_force()[1], target, 1e-4 * std::abs(target));
  EXPECT_LE(block.tool->q()[1], 4.445);
  block.drive(1.7, 4.46, 0);
  block.step();
  EXPECT_NEAR(block.tool->q()[1], 4.46, 1e-15);
}

// Places set after another tool's approach count.
TEST(ContactRun, ToolsMayBePlacedUntilTheFirstStep) {
  Block block;
  const auto second = driven_tool("second", std::make_shared<Circle>(1.), std::make_shared<Cartesian>());
  second->place("y", 9);
  block.setup->add_tool(second, make_coulomb(0));
  block.contact().approach(0, "y", block.u);
  second->place("x", 3);
  second->place("y", 2.2); // inside
  block.drive(1.7, 4.45, 0);
  for (const char* name : {"x", "y", "angle"}) second->prescription().move(name, 5);
  expect_invalid([&] { block.contact().begin(block.u, 0, 1, Stepping::IMPLICIT); },
                 "tool \"second\" starts inside the workpiece");
}
