// Names of all coordinates, nodes in contact with a tool, resultant of a tool's contact forces.
#include "contact/tool_report.hpp"
#include "geometry/circle.hpp"
#include "kinematics/cartesian.hpp"
#include "kinematics/polar.hpp"
#include "support/profile_tool.hpp"
#include <gtest/gtest.h>

using namespace burnish;
using namespace burnish::test;

namespace {

std::shared_ptr<const Tool<2>> roller(const char* name, bool polar = false) {
  std::shared_ptr<const Coordinates<2>> coordinates = std::make_shared<Cartesian>();
  if (polar) coordinates = std::make_shared<Polar>(Vector<2>(0, 0));
  return profile_tool(name, std::make_shared<Circle>(1.), coordinates);
}

ContactNode<2> node(NodeState state, int tool) {
  ContactNode<2> result;
  result.state = state;
  result.tool = tool;
  return result;
}

// Five candidates of the mesh nodes 1, 3, 4, 6, 7; two tools.
struct TwoTools : testing::Test {
  ContactModel<2> model;
  ContactState<2> state;
  void SetUp() override {
    model.candidates = {1, 3, 4, 6, 7};
    model.tools = {roller("upper"), roller("lower")};
    state.nodes = {node(NodeState::STICKING, 0), node(NodeState::SLIDING, 0), node(NodeState::FREE, 0),
                   node(NodeState::TOUCHED, 1), node(NodeState::FREE, -1)};
  }
};

} // namespace

TEST(CoordinateNames, PlainWithOneToolPrefixedWithSeveral) {
  EXPECT_EQ(coordinate_names<2>({roller("upper", true)}), (std::vector<std::string>{"r", "phi", "theta"}));
  EXPECT_EQ(
      coordinate_names<2>({roller("upper", true), roller("lower")}),
      (std::vector<std::string>{"upper.r", "upper.phi", "upper.theta", "lower.x", "lower.y", "lower.angle"}));
  EXPECT_THROW(coordinate_names<2>({roller("upper"), roller("upper")}), std::invalid_argument);
}

TEST_F(TwoTools, CountsNodesByStateAndTool) {
  EXPECT_EQ(count_nodes(state, "contact", "here"), 3);
  EXPECT_EQ(count_nodes(state, "free", "here"), 2);
  EXPECT_EQ(count_nodes(state, "contact", "here", 0), 2);
  EXPECT_EQ(count_nodes(state, "free", "here", 0), 1);
  EXPECT_EQ(count_nodes(state, "touched", "here", 1), 1);
  EXPECT_EQ(count_nodes(state, "sliding", "here", 1), 0);
  try {
    count_nodes(state, "stuck", "here");
    ADD_FAILURE() << "an unknown state was taken";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("here: unknown state \"stuck\""), std::string::npos);
  }
}

// The force on a tool is minus what its nodes receive; free nodes do not count.
TEST_F(TwoTools, ResultantOfEachTool) {
  Eigen::VectorXd R(16);
  for (int i = 0; i < 16; ++i) R[i] = 1 + i * i;
  EXPECT_EQ(tool_resultant(model, state, R, 0), -(R.segment<2>(2) + R.segment<2>(6)));
  EXPECT_EQ(tool_resultant(model, state, R, 1), -R.segment<2>(12));
}

TEST_F(TwoTools, ResultantWithoutWhatASupportTakes) {
  model.first = {0, 3, 6};
  model.constrained.resize(5);
  model.constrained[0] = {true, false}; // along x
  state.q = Eigen::VectorXd::Zero(6);
  state.nodes[0].place =
      model.tools[0]->surface().foot(Vector<2>(0, 2), Param<2>::Zero()).place; // the normal is y there
  Eigen::VectorXd R(16);
  for (int i = 0; i < 16; ++i) R[i] = 1 + i * i;
  const Vector<2> expected = -(Vector<2>(0, R[3]) + R.segment<2>(6));
  EXPECT_LT((tool_resultant(model, state, R, 0) - expected).norm(), 1e-12 * expected.norm());
}
