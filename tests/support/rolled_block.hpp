#pragma once
// An elastic block, pressed and rolled by a tool along a given path: for duality and invariance.
#include "support/run.hpp"
#include <iostream>

namespace burnish::test {

/// Residuals far below what is compared, with room for the iterations that this takes.
inline IterationOptions tight_options() {
  IterationOptions options;
  options.tolerance = 1e-11;
  options.offset_tolerance = 1e-9;
  options.gap_tolerance = 1e-7;
  options.max_iterations = 60;
  return options;
}

/// Block of 4 x 1.5, P2, clamped below, turned by `turn` about the origin.
struct RolledBlock {
  static constexpr int STEPS = 20;
  Scene scene;
  std::vector<Eigen::VectorXd> u; ///< displacement after every step
  std::vector<Eigen::VectorXd> q, force;

  explicit RolledBlock(std::shared_ptr<const Profile<2>> profile,
                       std::shared_ptr<const Coordinates<2>> coordinates, double mu, double turn = 0)
      : scene(block_mesh(16, 6, 2, 4, 1.5, turn), elastic_material(), tight_options()) {
    scene.add_tool(std::move(profile), std::move(coordinates), mu);
  }
  /// Takes all steps; program(step) sets the drive for its end.
  void run(const std::function<void(int step)>& program) {
    for (int k = 1; k <= STEPS; ++k) {
      program(k);
      ASSERT_EQ(converge(scene, (k - 1.) / STEPS, 1. / STEPS, Stepping::IMPLICIT), StepStatus::CONVERGED)
          << "step " << k << ": " << scene.why();
      accept(scene, {});
      u.push_back(scene.u);
      q.push_back(scene.tool->q());
      force.push_back(scene.tool->generalized_force());
    }
  }
  void move(const Eigen::VectorXd& to) {
    for (int k = 0; k < to.size(); ++k)
      scene.tool->prescription().move(scene.tool->prescription().names()[k], to[k]);
  }
  void load(const Eigen::VectorXd& with) {
    for (int k = 0; k < with.size(); ++k)
      scene.tool->prescription().force(scene.tool->prescription().names()[k], with[k]);
  }
};

/// Center and angle of a roller of radius 3 after a step: down by 0.1 until step 8, rolling by 0.28 from step
/// 6 on with a creep of 7 %.
inline Vector<3> roller_path(int step) {
  const double t = static_cast<double>(step) / RolledBlock::STEPS, roll = std::max(0., t - 0.3);
  return {1.7 + 0.4 * roll, 4.5 - 0.1 * std::min(1., t / 0.4), 0.1 - 0.143 * roll};
}

/// The same place in polar coordinates about a pivot.
inline Vector<3> polar_place(const Vector<3>& place, const Vector<2>& pivot) {
  const Vector<2> arm = place.head<2>() - pivot;
  return {arm.norm(), std::atan2(arm.y(), arm.x()), place[2]};
}

/// Expects equal displacements after every step; other(step) brings the second one into the first one's
/// frame.
template <class Other>
void expect_same_displacement(const RolledBlock& block, const Other& other, double tolerance) {
  double worst = 0, size = 0;
  for (int k = 0; k < RolledBlock::STEPS; ++k) {
    worst = std::max(worst, (block.u[k] - other(k)).cwiseAbs().maxCoeff());
    size = std::max(size, block.u[k].cwiseAbs().maxCoeff());
  }
  EXPECT_GE(size, 0.05);
  EXPECT_LE(worst, tolerance * size);
  std::cout << "displacements differ by " << worst / size << " of the largest one\n";
}

} // namespace burnish::test
