#pragma once
// A tool of any profile in any coordinates on the rolled block: the same steps under motion, under force, and the sum of
// its nodal forces by finite differences.
#include "support/rolled_block.hpp"

namespace burnish::test {

using Path = std::function<Eigen::VectorXd(int step)>;

struct AnyTool {
  std::shared_ptr<const Profile<2>> profile;
  std::shared_ptr<const Coordinates<2>> coordinates;
  Path path;            ///< coordinates after a step
  std::string approach; ///< coordinate that brings it to the body at the start; empty: it starts with a gap
};

inline std::vector<double> values(const Eigen::VectorXd& q) { return {q.data(), q.data() + q.size()}; }

inline std::unique_ptr<RolledBlock> placed(const AnyTool& tool, double mu) {
  auto block = std::make_unique<RolledBlock>(tool.profile, tool.coordinates, mu);
  block->scene.place(values(tool.path(0)));
  if (!tool.approach.empty()) block->scene.contact().approach(0, tool.approach, block->scene.u);
  return block;
}

/// sum_n dX(q,s_n)/dq^k . F_n over the nodes in contact, dX/dq by central differences of the surface map.
inline Eigen::VectorXd summed_forces(Scene& scene) {
  const auto& accepted = scene.contact().accepted();
  const auto& model = scene.contact().setup().model();
  const auto& tool = *model.tools[0];
  const Eigen::VectorXd q = accepted.contact.q;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(q.size());
  for (std::size_t i = 0; i < model.candidates.size(); ++i) {
    const auto& node = accepted.contact.nodes[i];
    if (!in_contact(node.state)) continue;
    const Vector<2> F = accepted.R.segment<2>(2 * model.candidates[i]);
    for (Eigen::Index k = 0; k < q.size(); ++k) {
      const double h = 1e-5;
      Eigen::VectorXd plus = q, minus = q;
      plus[k] += h;
      minus[k] -= h;
      sum[k] += F.dot(tool.point(plus, node.place).x - tool.point(minus, node.place).x) / (2 * h);
    }
  }
  return sum;
}

/// Duality: under motion, then under the forces that were read from the second step on, and the way back to the motion.
/// On the way: the summed nodal forces are those that the tool reports, and those that the program asks for.
inline void check_duality(const AnyTool& tool, const std::vector<int>& loaded, double mu = 0.3) {
  const auto moved = placed(tool, mu), driven = placed(tool, mu);
  const auto& names = tool.coordinates->names();
  moved->run([&](int k) { moved->move(tool.path(k)); });
  double unbalanced = 0;
  driven->run([&](int k) {
    if (k > 2)
      unbalanced =
          std::max(unbalanced, (summed_forces(driven->scene) - moved->force[k - 2]).cwiseAbs().maxCoeff());
    driven->move(tool.path(k));
    if (k == 1) return;
    for (const int c : loaded) driven->scene.tool->prescription().force(names[c], moved->force[k - 1][c]);
  });
  if (testing::Test::HasFatalFailure()) return;
  double worst = 0, travel = 0;
  for (int k = 0; k < RolledBlock::STEPS; ++k) {
    worst = std::max(worst, (driven->q[k] - tool.path(k + 1)).cwiseAbs().maxCoeff());
    travel = std::max(travel, (tool.path(k + 1) - tool.path(0)).cwiseAbs().maxCoeff());
  }
  EXPECT_LE(worst, 1e-9 * std::max(1., travel));
  EXPECT_GE(travel, 0.05);
  EXPECT_LE(unbalanced, 1e-8) << "summed nodal forces against the program";
  for (const int c : loaded) {
    double largest = 0;
    for (const auto& force : moved->force) largest = std::max(largest, std::abs(force[c]));
    EXPECT_GE(largest, 1e-3) << "no force, no test";
  }
  std::cout << "q recovered to " << worst << ", resultants to " << unbalanced << "\n";
  expect_same_displacement(
      *moved, [&](int k) { return driven->u[k]; }, 1e-9);
}

/// Invariance: both tools, moved along their paths, give the same displacements.
inline void check_same(AnyTool a, AnyTool b, double tolerance = 1e-9, double mu = 0.3) {
  a.approach = b.approach = ""; // an approach along another coordinate would touch elsewhere
  const auto first = placed(a, mu), second = placed(b, mu);
  first->run([&](int k) { first->move(a.path(k)); });
  second->run([&](int k) { second->move(b.path(k)); });
  if (testing::Test::HasFatalFailure()) return;
  expect_same_displacement(
      *first, [&](int k) { return second->u[k]; }, tolerance);
}

} // namespace burnish::test
