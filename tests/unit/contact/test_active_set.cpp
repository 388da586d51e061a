// Contact states on the dense block: which states nodes take, in which order, and the support of a tool.
#include "contact/active_set.hpp"
#include "contact/tool_support.hpp"
#include "unit/contact/event_scene.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// Six nodes, each on its own springs of stiffness 1 in x and y, under a plate moved by the program.
struct Springs : EventScene {
  PrescribedValues prescribed{{1, 1, 1}, Eigen::VectorXd::Zero(3)};
  std::vector<int> window = {0, 1, 2, 3, 4, 5};
  ActivePart flexibility;
  EntryPlaces<2> entry{std::vector<ContactNode<2>>(6), std::vector<EntryRecord>(6)};
  WindowProblem<2> problem;

  explicit Springs(double mu, double plate = 0) {
    add_plate(0, mu);
    prescribed.value[1] = plate;
    for (int i = 0; i < 6; ++i) {
      entry.nodes[i].tool = 0;
      enter_at(i, 20 - i);
    }
    flexibility.set(std::make_shared<const Eigen::MatrixXd>(Eigen::MatrixXd::Identity(12, 12)));
    problem.window = &window;
    problem.flexibility = &flexibility;
    problem.free_increment = Eigen::VectorXd::Zero(12);
    problem.u = &u0;
    problem.R = &R0;
    problem.entry = &entry;
    problem.model = &model;
    problem.body = &body;
    problem.prescribed = &prescribed;
    problem.start = &start;
    problem.tolerances = {1e-9, 1e-9, 1e-10};
  }
  Springs(const Springs&) = delete; // the problem points into it
  void enter_at(int i, double s) { place_at(entry.nodes[i], place_of(*model.tools[0], s)); }
  WindowSolution<2> solve() const { return solve_window(problem); }
  static double pressure(const WindowSolution<2>& solution, int i) { return -solution.F[2 * i + 1]; }
};

} // namespace

TEST(ActiveSet, PenetratingNodesStickWhereTheyEnter) {
  Springs springs(0.3, -0.1);
  springs.problem.free_increment[2 * 4 + 1] = -0.5; // out of reach
  springs.enter_at(2, 18.02);
  const auto solution = springs.solve();
  EXPECT_EQ(solution.passes, 3) << "of each run of neighbors one at a time";
  for (int i = 0; i < 6; ++i) {
    EXPECT_STREQ(name_of(solution.state.nodes[i].state), i == 4 ? "free" : "sticking");
    EXPECT_NEAR(Springs::pressure(solution, i), i == 4 ? 0 : 0.1, 1e-14);
  }
  EXPECT_EQ(EventScene::s(solution.state.nodes[2]), 18.02);
  EXPECT_NEAR(solution.F[4], -0.02, 1e-13) << "pulled to the place where it sticks";
  EXPECT_NEAR(solution.state.q[1], -0.1, 1e-15);
}

// What nothing resists is where it rests, wherever the iteration before has taken it.
TEST(ActiveSet, IdleCoordinateGoesToItsPlaceAtRest) {
  Springs springs(0.3, 0.1); // out of reach
  springs.prescribed.is_motion[0] = 0;
  springs.start.q[0] = 0.5;
  const Eigen::VectorXd resting = Eigen::Vector3d(0.25, 0, 0);
  EXPECT_EQ(springs.solve().state.q[0], 0.5);
  springs.problem.resting = &resting;
  EXPECT_EQ(springs.solve().state.q[0], 0.25);
}

TEST(ActiveSet, WithoutFrictionNodesSlide) {
  Springs springs(0, -0.1);
  const auto solution = springs.solve();
  for (int i = 0; i < 6; ++i) {
    EXPECT_STREQ(name_of(solution.state.nodes[i].state), "sliding");
    EXPECT_TRUE(solution.state.nodes[i].slip_direction.isZero());
    EXPECT_NEAR(solution.F[2 * i], 0, 1e-14);
  }
}

// Adhesion: a sticking node slides first if its friction tells a direction, else it is released (METHOD.md 5.4).
TEST(ActiveSet, StickingNodeSlidesBeforeItIsReleased) {
  for (const double side : {0.5, 0.}) {
    Springs springs(0.3, 0.1);
    springs.touch(2, NodeState::STICKING, 0);
    springs.touch(3, NodeState::SLIDING, 1);
    springs.problem.free_increment[4] = side; // against its friction
    springs.problem.max_passes = 2;
    auto solution = springs.solve();
    EXPECT_STREQ(name_of(solution.state.nodes[2].state), side > 0 ? "sliding" : "free");
    EXPECT_STREQ(name_of(solution.state.nodes[3].state), "free");
    springs.problem.max_passes = 12;
    solution = springs.solve();
    EXPECT_STREQ(name_of(solution.state.nodes[2].state), "free");
    EXPECT_TRUE(solution.state.nodes[2].slip_direction.isZero());
    EXPECT_EQ(solution.passes, side > 0 ? 3 : 2);
    EXPECT_EQ(solution.F.norm(), 0);
  }
}

// The body pushes node 1 sideways by 0.5 under N = 0.1, mu = 0.3: it slides until T = 0.03 is left.
TEST(ActiveSet, FrictionExhaustedSlides) {
  for (const double side : {1., -1.}) {
    Springs springs(0.3, -0.1);
    springs.touch(1, NodeState::STICKING, 0);
    springs.problem.free_increment[2] = 0.5 * side;
    const auto solution = springs.solve();
    const auto& node = solution.state.nodes[1];
    EXPECT_STREQ(name_of(node.state), "sliding");
    EXPECT_NEAR(springs.along(node), -side, 1e-15) << "s runs against x";
    EXPECT_NEAR(solution.F[2], -0.03 * side, 1e-13);
    EXPECT_NEAR(EventScene::s(node) - EventScene::origin(node), -0.47 * side, 1e-13);
  }
}

TEST(ActiveSet, BackwardSlipSticks) {
  Springs springs(0.3, -0.1);
  springs.touch(1, NodeState::SLIDING, 1);
  springs.problem.free_increment[2] = 0.01; // along -s, too little to slide that way
  const auto solution = springs.solve();
  EXPECT_STREQ(name_of(solution.state.nodes[1].state), "sticking");
  EXPECT_EQ(EventScene::s(solution.state.nodes[1]), EventScene::origin(solution.state.nodes[1]));
  EXPECT_NEAR(solution.F[2], -0.01, 1e-13);
}

// A row of a flange that is drawn along under its holder enters sliding, and its run one at a time (ALGORITHMS.md 5.3).
TEST(ActiveSet, DrawnRowEntersSliding) {
  Springs springs(0.3, -0.1);
  for (int i = 0; i < 6; ++i) springs.enter_at(i, 20.4 - i);
  const auto solution = springs.solve();
  EXPECT_EQ(solution.left, 0);
  EXPECT_LE(solution.passes, 7) << "no node sticks first";
  for (int i = 0; i < 6; ++i) {
    EXPECT_STREQ(name_of(solution.state.nodes[i].state), "sliding");
    EXPECT_NEAR(springs.along(solution.state.nodes[i]), -1, 1e-15);
    EXPECT_NEAR(solution.F[2 * i], -0.03, 1e-13);
  }
}

// Where it stuck its spring pulls it off the tool again and again: it gives that place up after two releases.
TEST(ActiveSet, FullStickingReturnsTwiceToItsPlace) {
  Springs springs(0.3, -0.1);
  springs.enter_at(2, 18.02);
  for (const bool sticks_always : {true, false})
    for (const int times : {1, 2}) {
      if (sticks_always)
        springs.model.laws = {TangentialLaw<2>(std::make_shared<StickingFriction>())};
      else
        springs.model.laws = {TangentialLaw<2>(make_coulomb(0.3))};
      springs.entry.records[2].releases = times;
      const auto solution = springs.solve();
      EXPECT_NEAR(EventScene::s(solution.state.nodes[2]), sticks_always && times == 2 ? 18 : 18.02, 1e-14);
    }
  springs.model.laws = {TangentialLaw<2>(std::make_shared<StickingFriction>())};
  springs.prescribed.value[1] = 0.1; // the plate lifts
  springs.touch(2, NodeState::STICKING, 0);
  springs.solve();
  EXPECT_EQ(springs.entry.records[2].releases, 3) << "counted, over all calls of a step";
}

TEST(ActiveSet, StatesStayInEventStepping) {
  Springs springs(0.3, 0.1);
  springs.touch(2, NodeState::STICKING, 0);
  springs.problem.adapt = false;
  const auto solution = springs.solve();
  EXPECT_STREQ(name_of(solution.state.nodes[2].state), "sticking");
  EXPECT_NEAR(Springs::pressure(solution, 2), -0.1, 1e-14);
  EXPECT_STREQ(name_of(solution.state.nodes[0].state), "free");
  EXPECT_EQ(solution.passes, 1);
}

namespace {

/// A body that only the plate holds (a shift, here of nothing): nodes 1, 2 slide along s, 3, 4 against it.
struct NeutralPoint : Springs {
  explicit NeutralPoint(const Eigen::VectorXd& added_stiffness) : Springs(0.3, -0.1) {
    const double slips[] = {0.4, 0.1, -0.2, -0.3};
    for (int i = 1; i < 5; ++i) {
      touch(i, NodeState::SLIDING, i < 3 ? 1 : -1);
      slip(start.nodes[i], slips[i - 1]);
    }
    problem.added_stiffness = added_stiffness;
  }
};

} // namespace

TEST(ActiveSet, FloatingBodySticksAtTheNeutralPoint) {
  for (const bool floating : {true, false}) {
    NeutralPoint springs(Eigen::VectorXd::Zero(floating ? 12 : 0));
    springs.problem.max_passes = 1;
    const auto solution = springs.solve();
    for (int i = 1; i < 5; ++i)
      EXPECT_STREQ(name_of(solution.state.nodes[i].state), floating && i == 2 ? "sticking" : "sliding");
  }
  NeutralPoint springs(Eigen::VectorXd::Zero(12)); // all slide the same way: nothing to choose
  for (int i = 3; i < 5; ++i) springs.start.nodes[i].slip_direction *= -1;
  springs.problem.max_passes = 1;
  EXPECT_STREQ(name_of(springs.solve().state.nodes[2].state), "sliding");
}

// The springs pull every node farther than friction holds: the trials end and all slide.
TEST(ActiveSet, FloatingBodyMaySlideEverywhere) {
  NeutralPoint springs(Eigen::VectorXd::Zero(12));
  for (int i = 1; i < 5; ++i) springs.problem.free_increment[2 * i] = i < 3 ? -0.9 : 0.9;
  const auto solution = springs.solve();
  for (int i = 1; i < 5; ++i) {
    EXPECT_STREQ(name_of(solution.state.nodes[i].state), "sliding");
    EXPECT_NEAR(springs.along(solution.state.nodes[i]), i < 3 ? 1 : -1, 1e-15);
  }
  EXPECT_LE(solution.passes, 6);
}

// On a curved tool, too, trials to stick leave nothing behind: nodes that slide again do so from where the iteration began, not
// from where they stuck.
TEST(ActiveSet, NodesSlideOnFromWhereTheyWere) {
  Springs springs(0.3);
  springs.model.tools[0] =
      profile_tool("roller", std::make_shared<Circle>(40, false), std::make_shared<Cartesian>());
  springs.start.q = springs.prescribed.value = Eigen::Vector3d(2.5, 39.9, 0);
  const double slips[] = {0.4, 0.1, -0.2, -0.3};
  for (int i = 1; i < 5; ++i) {
    springs.touch(i, NodeState::SLIDING, i < 3 ? -1 : 1);
    ContactNode<2>& node = springs.start.nodes[i];
    node.slip_origin = place_of(*springs.model.tools[0], EventScene::s(node) + slips[i - 1]);
    springs.problem.free_increment[2 * i] = i < 3 ? -0.05 : 0.05; // more than friction holds
  }
  for (const int i : {0, 5}) springs.problem.free_increment[2 * i + 1] = -1; // out of reach
  const Eigen::VectorXd added = Eigen::VectorXd::Zero(12);
  springs.problem.adapt = false;
  const Eigen::VectorXd F = springs.solve().F;
  springs.problem.adapt = true;
  springs.problem.added_stiffness = added;
  const auto solution = springs.solve();
  EXPECT_GT(solution.passes, 1) << "a neutral point was looked for";
  for (int i = 1; i < 5; ++i) EXPECT_STREQ(name_of(solution.state.nodes[i].state), "sliding");
  EXPECT_LE((solution.F - F).norm(), 1e-12);
}

// Along a plate without friction nothing resists x: it keeps its place where it is in balance there, and is named where it is not.
TEST(ActiveSet, UnresistedCoordinateKeepsItsPlaceInBalance) {
  for (const double force : {0., 0.01}) {
    Springs springs(0, -0.1);
    springs.prescribed.is_motion[0] = 0;
    springs.prescribed.value[0] = force;
    springs.start.q[0] = 0.5;
    const auto solution = springs.solve();
    EXPECT_EQ(solution.singular, force > 0);
    if (force > 0) {
      EXPECT_EQ(solution.weakest_coordinate, 0);
      continue;
    }
    EXPECT_EQ(solution.state.q[0], 0.5);
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(Springs::pressure(solution, i), 0.1, 1e-14);
  }
}

TEST(ActiveSet, SingularBlockIsReported) {
  Springs springs(0.3);
  springs.prescribed.is_motion[1] = 0; // a load on the plate that touches nothing
  springs.prescribed.value[1] = -1;
  const auto solution = springs.solve();
  EXPECT_TRUE(solution.singular);
  EXPECT_EQ(solution.weakest_coordinate, 1);
}

namespace {

/// Three sliding nodes with slips 0.3, 0.1, 0.2; x of the plate, which only friction resists, under force.
struct Sliding : Springs {
  explicit Sliding(double mu) : Springs(mu) {
    const double slips[] = {0.3, 0.1, 0.2};
    for (int i = 0; i < 3; ++i) {
      touch(i, NodeState::SLIDING, mu > 0 ? 1 : 0);
      slip(start.nodes[i], slips[i]);
    }
    prescribed.is_motion[0] = 0;
  }
  int stick(const std::vector<char>& refused = {}) {
    return stick_unsupported(model, prescribed, start, refused);
  }
};

} // namespace

TEST(StickUnsupported, NodeOfTheSmallestSlipSticks) {
  Sliding springs(0.3);
  EXPECT_EQ(springs.stick(), 1);
  const auto& node = springs.start.nodes[1];
  EXPECT_STREQ(name_of(node.state), "sticking");
  EXPECT_EQ(EventScene::s(node), EventScene::origin(node));
  EXPECT_TRUE(node.slip_direction.isZero());
  EXPECT_EQ(springs.stick(), -1) << "one is enough";
}

// Nodes that could not stick come last; among them, too, the one of the smallest slip comes first.
TEST(StickUnsupported, RefusedNodesComeLast) {
  EXPECT_EQ(Sliding(0.3).stick({0, 1, 0, 0, 0, 0}), 2);
  EXPECT_EQ(Sliding(0.3).stick({0, 1, 1, 0, 0, 0}), 0);
  EXPECT_EQ(Sliding(0.3).stick({1, 1, 1, 0, 0, 0}), 1);
}

TEST(StickUnsupported, NotNeeded) {
  Sliding springs(0.3);
  springs.prescribed.is_motion = {1, 0, 0}; // y and angle under force: pressure resists them
  place_at(springs.start.nodes[0], place_of(*springs.model.tools[0], 19));
  EXPECT_EQ(springs.stick(), -1);
  EXPECT_EQ(Sliding(0).stick(), -1) << "nothing could stick";
  Springs nothing(0.3);
  nothing.prescribed.is_motion[0] = 0;
  EXPECT_EQ(stick_unsupported(nothing.model, nothing.prescribed, nothing.start), -1) << "no contact";
}
