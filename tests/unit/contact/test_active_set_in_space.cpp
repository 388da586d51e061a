// Passes of the active set on a surface in space: which nodes of a patch change at once, and when the passes end without a solution.
#include "base/stop_request.hpp"
#include "contact/active_set.hpp"
#include "geometry/plane_surface.hpp"
#include "kinematics/cartesian_in_space.hpp"
#include <gtest/gtest.h>

using namespace burnish;

namespace {

/// A square of nodes in the plane z = 0, each on springs of its own, pressed into a plane at rest below them; neighbors share a side.
struct Patch {
  int side;
  ContactModel<3> model;
  BodyView<3> body;
  ContactState<3> start;
  PrescribedValues prescribed{std::vector<char>(6, 1), Eigen::VectorXd::Zero(6)};
  std::vector<int> window;
  ActivePart flexibility;
  EntryPlaces<3> entry;
  Eigen::VectorXd zero;
  WindowProblem<3> problem;

  explicit Patch(int nodes_a_side) : side(nodes_a_side) {
    const int n = side * side;
    model.tools = {std::make_shared<Tool<3>>(
        "tool", std::make_shared<PlaneSurface>(Vector<3>(0, 0, 0), Vector<3>(0, 0, 1), 1),
        std::make_shared<CartesianInSpace>())};
    model.laws.emplace_back(make_coulomb(0));
    model.first = {0, 6};
    model.neighbors.resize(n);
    body.X = zero = Eigen::VectorXd::Zero(3 * n);
    for (int i = 0; i < n; ++i) {
      model.candidates.push_back(i);
      window.push_back(i);
      body.X.segment<2>(3 * i) << i % side, i / side;
      for (const int next : {i % side > 0 ? i - 1 : -1, i % side < side - 1 ? i + 1 : -1, i - side, i + side})
        if (next >= 0 && next < n) model.neighbors[i].push_back(next);
    }
    body.fixed.assign(3 * n, 0);
    body.spacing = 1;
    start.nodes.resize(n);
    start.q = Eigen::VectorXd::Zero(6);
    entry = {std::vector<ContactNode<3>>(n), std::vector<EntryRecord>(n)};
    for (auto& node : entry.nodes) node.tool = 0;
    set_flexibility(Eigen::MatrixXd::Identity(3 * n, 3 * n), true);
    state_problem();
  }
  Patch(const Patch&) = delete; // the problem points into it
  void state_problem() {
    problem.model = &model;
    problem.body = &body;
    problem.prescribed = &prescribed;
    problem.start = &start;
    problem.window = &window;
    problem.flexibility = &flexibility;
    problem.free_increment = problem.added_stiffness = zero;
    problem.added_stiffness.resize(0);
    problem.u = problem.R = &zero;
    problem.entry = &entry;
    problem.tolerances = {1e-9, 1e-9, 1e-10};
    problem.tolerances.tool_force = Eigen::VectorXd::Constant(1, 1e-9);
  }
  void set_flexibility(Eigen::MatrixXd C, bool symmetric) {
    flexibility.set(std::make_shared<const Eigen::MatrixXd>(std::move(C)), symmetric);
  }
  /// Without contact node (i, j) would be that far inside.
  void press(int i, int j, double depth) { problem.free_increment[3 * (side * j + i) + 2] = -depth; }
};

} // namespace

// Depths fall from one corner to the other: in each pass a diagonal of the patch enters.
TEST(ActiveSetInSpace, OfAPatchEachEntersThatIsDeepestNextToIt) {
  Patch patch(7);
  for (int j = 0; j < 7; ++j)
    for (int i = 0; i < 7; ++i) patch.press(i, j, 1 + 0.1 * (i + j));
  const auto solution = solve_window(patch.problem);
  EXPECT_EQ(solution.left, 0);
  EXPECT_EQ(solution.passes, 14) << "13 diagonals";
  for (int i = 0; i < 49; ++i) EXPECT_NEAR(solution.F[3 * i + 2], 1 + 0.1 * (i % 7 + i / 7), 1e-14);
}

// A body of negative stiffness: in contact it is drawn, free it is inside. No state is right.
TEST(ActiveSetInSpace, PassesThatGoRoundEnd) {
  Patch patch(1);
  patch.set_flexibility(Eigen::Vector3d(1, 1, -1).asDiagonal(), false);
  patch.press(0, 0, 0.1);
  const auto solution = solve_window(patch.problem);
  EXPECT_EQ(solution.left, 1);
  EXPECT_EQ(solution.passes, patch.problem.max_passes);
  EXPECT_FALSE(solution.singular);
}

TEST(ActiveSetInSpace, PassesEndWhenTheRunShallEnd) {
  Patch patch(7);
  for (int j = 0; j < 7; ++j)
    for (int i = 0; i < 7; ++i) patch.press(i, j, 1 + 0.1 * (i + j));
  int asked = 0;
  set_stop_asked([&] { return ++asked == 3; });
  const auto stopped = solve_window(patch.problem);
  EXPECT_TRUE(stopped.stopped);
  EXPECT_EQ(stopped.passes, 3);
  set_stop_asked({});
  const auto solution = solve_window(patch.problem);
  EXPECT_FALSE(solution.stopped);
  EXPECT_EQ(solution.passes, 14);
}
