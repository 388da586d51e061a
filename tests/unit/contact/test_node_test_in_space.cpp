// Where a node that enters in space takes its place, and how it goes on from there.
#include "contact/node_test.hpp"
#include "geometry/plane_surface.hpp"
#include "kinematics/cartesian_in_space.hpp"
#include <gtest/gtest.h>

using namespace burnish;

namespace {

/// A plane z = 0 that presses upward, one candidate that stood above (0, 0, gap) when the step began.
struct EnteringNode {
  ContactModel<3> model;
  EntryPlaces<3> entry{std::vector<ContactNode<3>>(1), std::vector<EntryRecord>(1)};
  Tolerances tolerances;
  ContactNode<3> node;

  explicit EnteringNode(double gap) {
    model.tools = {std::make_shared<Tool<3>>(
        "tool", std::make_shared<PlaneSurface>(Vector<3>(0, 0, 0), Vector<3>(0, 0, 1), 1),
        std::make_shared<CartesianInSpace>())};
    model.laws.emplace_back(make_coulomb(0.3));
    model.first = {0, 6};
    model.candidates = {0};
    entry.nodes[0].tool = 0;
    entry.records[0].gap = gap;
    tolerances.gap = 1e-3;
    tolerances.tool_force = Eigen::VectorXd::Ones(1);
  }
  bool at(const Vector<3>& x) {
    const auto poses = model.poses(Eigen::VectorXd::Zero(6));
    return NodeTest<3>(model, poses, tolerances, entry)(0, node, Vector<3>::Zero(), {}, x, node);
  }
};

} // namespace

// Its gap closes linearly: from 0.3 to -0.1 on the way to x = 0.4, so it has touched at 0.3 and slid since.
TEST(EnteringNode, SlidesFromThePlaceOfTouching) {
  EnteringNode s(0.3);
  ASSERT_TRUE(s.at({0.4, 0, -0.1}));
  EXPECT_LE((s.node.slip_origin.y - Vector<3>(0.3, 0, 0)).norm(), 1e-14);
  EXPECT_LE((s.node.place.y - Vector<3>(0.4, 0, 0)).norm(), 1e-14);
  EXPECT_EQ(s.node.state, NodeState::SLIDING);
  EXPECT_LE((s.node.slip_direction - Vector<3>::UnitX()).norm(), 1e-14);
}

TEST(EnteringNode, SticksWhereItComesStraightDown) {
  EnteringNode s(0.3);
  ASSERT_TRUE(s.at({1e-3, 0, -0.1}));
  EXPECT_EQ(s.node.state, NodeState::STICKING);
  EXPECT_LE((s.node.slip_origin.y - Vector<3>(0.75e-3, 0, 0)).norm(), 1e-14);
}

// One that was in contact when the step began comes back to its own place.
TEST(EnteringNode, HeldBeforeComesBack) {
  EnteringNode s(0.3);
  s.entry.nodes[0].state = NodeState::STICKING;
  ASSERT_TRUE(s.at({1e-3, 0, -0.1}));
  EXPECT_EQ(s.node.slip_origin.y.norm(), 0);
}
