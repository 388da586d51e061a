// Warnings of a scene: each kind found once, and not where there is nothing to warn of.
#include "diagnosis/diagnosis.hpp"
#include "geometry/circle.hpp"
#include "geometry/segment.hpp"
#include "kinematics/cartesian.hpp"
#include "support/profile_tool.hpp"
#include "support/structured_mesh.hpp"
#include "unit/finite_difference.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

/// Block 4 x 1, nodes on its top at x = 0, 0.5, 1, .. 4; all tools face down.
struct WarnedBlock {
  ContactMesh mesh = block_mesh(8, 2, 1, 4, 1);
  ContactSetup<2> setup{mesh.space, mesh.surface, mesh.fixed, std::make_shared<EdgeMeasure>()};
  ContactState<2> state;
  Eigen::VectorXd u = Eigen::VectorXd::Zero(mesh.space.num_dofs());
  Diagnosis<2> diagnosis;

  void add(const std::string& name, std::shared_ptr<const Profile<2>> profile, const Vector<2>& place,
           const std::vector<Facet<2>>& reach = {}) {
    const auto tool = driven_tool(name, std::move(profile), std::make_shared<Cartesian>());
    tool->place("x", place[0]);
    tool->place("y", place[1]);
    setup.add_tool(tool, make_coulomb(0.3), reach);
  }
  /// A flat punch of this width that faces down, its middle at the place.
  void add_punch(const std::string& name, double width, const Vector<2>& place,
                 const std::vector<Facet<2>>& reach = {}) {
    add(name, std::make_shared<Segment>(Vector<2>(width / 2, 0), Vector<2>(-width / 2, 0)), place, reach);
  }
  void close() {
    setup.close();
    state.q = setup.placed();
    state.nodes.resize(setup.candidates().size());
  }
  /// Candidate at this place of the top.
  int at(double x) const {
    for (std::size_t i = 0; i < setup.candidates().size(); ++i)
      if (std::abs(setup.mesh().node(setup.candidates()[i])[0] - x) < 1e-9) return static_cast<int>(i);
    ADD_FAILURE() << "no node at " << x;
    return 0;
  }
  void touch(int tool, const std::vector<double>& places) {
    for (const double x : places) {
      state.nodes[at(x)].tool = tool;
      state.nodes[at(x)].state = NodeState::STICKING;
    }
  }
  /// Two accepted steps; what was found of the contact.
  std::vector<Finding> check() {
    const Eigen::VectorXd R = Eigen::VectorXd::Zero(u.size()), Q = Eigen::VectorXd::Zero(state.q.size());
    AcceptedStep<2> step{setup, state, u, R, Q};
    step.allowed.offset = IterationOptions().offset_tolerance * setup.body().spacing;
    diagnosis.set_checks(false);
    diagnosis.begin(step);
    for (const double t : {0.5, 0.75}) {
      step.t = t;
      diagnosis.look(step);
    }
    return diagnosis.findings().list();
  }
  void expect_none() {
    for (const Finding& warning : check()) ADD_FAILURE() << warning.text;
  }
  void expect_one(const std::string& text) {
    const auto list = check();
    ASSERT_EQ(list.size(), 1u);
    EXPECT_EQ(list[0].text, text);
  }
};

const Vector<2> TOP(2, 1);

} // namespace

TEST(ContactWarnings, NoneForARollerOnTheBlock) {
  WarnedBlock block;
  block.add("roller", std::make_shared<Circle>(3.), {2, 4});
  block.close();
  block.touch(0, {1.5, 2, 2.5});
  block.expect_none();
}

// --- curvature

TEST(ContactWarnings, RadiusSmallerThanTheSpacing) {
  WarnedBlock block;
  block.add("needle", std::make_shared<Circle>(0.4), {2, 1.4});
  block.close();
  block.expect_one(
      "the tightest radius of tool \"needle\", 0.4, is smaller than the distance of the contact nodes, "
      "0.5: the mesh cannot follow it there, refine the contact surface");
}

TEST(ContactWarnings, EachToolThatIsTooTight) {
  WarnedBlock block;
  block.add("a", std::make_shared<Circle>(0.4), {1, 5});
  block.add("b", std::make_shared<Circle>(0.51), {2, 5}); // larger than the spacing
  block.add("c", std::make_shared<Circle>(0.3), {3, 5});
  block.add_punch("flat", 1, {3, 7});
  block.close();
  const auto list = block.check();
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].subject, "curvature a");
  EXPECT_EQ(list[1].subject, "curvature c");
}

// --- two tools

TEST(ContactWarnings, AnotherToolReachesForANode) {
  WarnedBlock block;
  block.add("left", std::make_shared<Circle>(1.), {1, 2});
  block.add("right", std::make_shared<Circle>(1.), {1, 1.9});
  block.close();
  block.touch(0, {1});
  const int node = block.setup.candidates()[block.at(1)];
  block.expect_one(
      "tools \"left\" and \"right\" reach for the same node " + std::to_string(node) +
      " at 1 1, t = 0.5: it stays with \"left\", and \"right\" overlaps it by 0.1; a node touches at most "
      "one tool");
}

TEST(ContactWarnings, NoConflictWithoutOverlapContactOrReach) {
  for (const bool reaches : {false, true}) {
    WarnedBlock block;
    std::vector<Facet<2>> end; // of the block, right
    for (const auto& facet : block.mesh.surface)
      if (block.mesh.space.node(facet.vertex[0])[0] > 3.4 && block.mesh.space.node(facet.vertex[1])[0] > 3.4)
        end.push_back(facet);
    block.add("left", std::make_shared<Circle>(1.), {1, 2});
    block.add("right", std::make_shared<Circle>(1.), {1, reaches ? 2 - 1e-5 : 1.9},
              reaches ? block.mesh.surface : end);
    block.close();
    block.touch(0, {1});
    block.expect_none(); // 1e-5 is within offset_tolerance x 0.5; or the other tool may not touch it
  }
  WarnedBlock free;
  free.add("left", std::make_shared<Circle>(1.), {1, 2});
  free.add("right", std::make_shared<Circle>(1.), {1, 1.9});
  free.close();
  free.expect_none();
}

// Nodes at 1.5 and 2, then again at 3 and 3.5: elements with nodes of both tools, in either order.
TEST(ContactWarnings, ElementsBetweenTwoTools) {
  for (const bool swapped : {false, true}) {
    WarnedBlock block;
    block.add_punch("a", 20, TOP);
    block.add_punch("b", 20, TOP);
    block.close();
    block.touch(swapped ? 1 : 0, {1, 1.5, 3.5, 4});
    block.touch(swapped ? 0 : 1, {2, 2.5, 3});
    const auto list = block.check();
    ASSERT_EQ(list.size(), 1u) << "one for the pair";
    const std::string& text = list[0].text;
    EXPECT_EQ(text.find("an element lies between tools \"a\" and \"b\" (element "), 0u) << text;
    EXPECT_NE(text.find(", t = 0.5): refine the workpiece there"), std::string::npos) << text;
  }
}

TEST(ContactWarnings, ToolsApartShareNoElement) {
  WarnedBlock block;
  block.add_punch("a", 20, TOP);
  block.add_punch("b", 20, TOP);
  block.close();
  block.touch(0, {1, 1.5});
  block.touch(1, {2.5, 3});
  block.expect_none();
}

// --- ends

TEST(ContactWarnings, ContactAtTheEndOfATool) {
  WarnedBlock block;
  block.add_punch("punch", 2, TOP); // x = 1 .. 3
  block.close();
  block.touch(0, {1, 1.5, 2, 2.5, 3});
  block.expect_one(
      "the contact has reached the end of tool \"punch\" at 3 1, t = 0.5: the tool is sharp there; let its "
      "profile go on, with a fillet");
}

TEST(ContactWarnings, NoEndWhereTheBodyEndsTheContactEndsOrTheToolIsClosed) {
  WarnedBlock wide; // the punch goes on beyond the body
  wide.add_punch("punch", 8, TOP);
  wide.close();
  wide.touch(0, {0, 0.5, 1, 3, 3.5, 4});
  wide.expect_none();
  WarnedBlock flush; // as wide as the body: nothing beyond its ends
  flush.add_punch("punch", 4, TOP);
  flush.close();
  flush.touch(0, {0, 0.5, 1, 3, 3.5, 4});
  flush.expect_none();
  WarnedBlock inner; // contact far from the ends
  inner.add_punch("punch", 3, TOP);
  inner.close();
  inner.touch(0, {1.5, 2, 2.5});
  inner.expect_none();
  WarnedBlock away; // an end close to the body without contact
  away.add_punch("punch", 2, {2, 1.1});
  away.close();
  away.expect_none();
}

TEST(ContactWarnings, EndsOfTwoToolsAreTwoWarnings) {
  WarnedBlock block;
  block.add_punch("a", 1, {0.75, 1});
  block.add_punch("b", 1, {3, 1});
  block.close();
  block.touch(0, {0.5, 1});
  block.touch(1, {2.5, 3, 3.5});
  const auto list = block.check();
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].subject, "end a");
  EXPECT_EQ(list[1].subject, "end b");
}
