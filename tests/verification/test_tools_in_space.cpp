// A ball on a block in space: other coordinates, a turned frame, motion and force exchanged (METHOD.md 8, T2, T3), the same
// friction in every direction of the plane; at tight tolerances and at the default ones.
#include "kinematics/polar_in_space.hpp"
#include "support/space_scene.hpp"
#include <iostream>

using namespace burnish;
using namespace burnish::test;

namespace {

constexpr int STEPS = 10;
const double RADIUS = 2;
using Way = std::function<Eigen::VectorXd(int step)>;

/// Center and rotation vector: down by 0.08, sideways, spinning and rolling.
Vector<3> center(int k) {
  const double t = 1. * k / STEPS, along = std::max(0., t - 0.4);
  return {0.13 + 0.12 * along, -0.07 + 0.05 * along, RADIUS - 0.08 * std::min(1., t / 0.5)};
}
Vector<3> spin(int k) { return 0.05 * k / STEPS * Vector<3>(0.3, 1, 0.6); }
Eigen::VectorXd cartesian(int k) {
  Eigen::VectorXd q(6);
  q << center(k), spin(k);
  return q;
}

struct Record {
  std::vector<Eigen::VectorXd> u, force, q;
};

Record run(SpaceScene& scene, const Way& way, const std::function<void(int)>& program) {
  Record record;
  scene.place(way(0));
  scene.start();
  if (way(0)[2] == 0) scene.contact->approach(0, "z", scene.u); // touches at the start
  for (int k = 1; k <= STEPS; ++k) {
    scene.move(way(k));
    program(k);
    scene.step((k - 1.) / STEPS, 1. / STEPS);
    if (testing::Test::HasFatalFailure()) break;
    record.u.push_back(scene.u);
    record.force.push_back(scene.tool->generalized_force());
    record.q.push_back(scene.tool->q());
  }
  return record;
}

/// Tolerances of a run, and what the same run in another way may be off by.
struct Accuracy {
  std::string name;
  IterationOptions options;
  double displacement; ///< over the largest one, where the motion is given
  double force;
  double coordinate;          ///< found again under force; ways are 0.08, the block is 1 high
  double dual_force;          ///< under motion and under force
  double driven_displacement; ///< under force, over the largest one
};

class ToolsInSpaceAt : public testing::TestWithParam<Accuracy> {
protected:
  Record moved(const std::shared_ptr<const Coordinates<3>>& coordinates, const Way& way,
               const BlockOfTetrahedra& block = {}) const {
    SpaceScene scene(block, sphere(RADIUS), coordinates, 0.3, GetParam().options);
    return run(scene, way, [](int) {});
  }
  void check_duality(const std::shared_ptr<const Surface<3>>& surface, const Way& way, double mu,
                     const std::vector<int>& loaded) const;
};

double difference(const Record& a, const Record& b, const Tensor<3>& turn = Tensor<3>::Identity()) {
  double worst = 0, size = 0;
  for (int k = 0; k < STEPS; ++k)
    for (Eigen::Index n = 0; n < a.u[k].size(); n += 3) {
      worst = std::max(worst, (turn * a.u[k].segment<3>(n) - b.u[k].segment<3>(n)).norm());
      size = std::max(size, a.u[k].segment<3>(n).norm());
    }
  EXPECT_GE(size, 0.03);
  return worst / size;
}

} // namespace

TEST_P(ToolsInSpaceAt, EulerAnglesAndFormulasAgainstARotationVector) {
  const auto a = moved(std::make_shared<CartesianInSpace>(), cartesian);
  ASSERT_FALSE(HasFatalFailure());
  const auto euler = std::make_shared<FormulaCoordinates<3>>(
      "tool", std::vector<std::string>{"x", "y", "z", "phi", "theta", "psi"},
      SpaceFormulas{"x", "y", "z", "z:phi x:theta z:psi"});
  const auto b = moved(euler, [](int k) {
    const Vector<3> v = spin(k);
    const Tensor<3> R = v.norm() > 0 ? turn_about(v, v.norm()) : Tensor<3>(Tensor<3>::Identity());
    Eigen::VectorXd q(6);
    q << center(k), R.eulerAngles(2, 0, 2);
    return q;
  });
  ASSERT_FALSE(HasFatalFailure());
  const double apart = difference(a, b);
  EXPECT_LE(apart, GetParam().displacement);
  for (int k = 0; k < STEPS; ++k) EXPECT_LE((a.force[k] - b.force[k]).head<3>().norm(), GetParam().force);
  std::cout << "displacements differ by " << apart << " of the largest one\n";
}

TEST_P(ToolsInSpaceAt, AMovedReferencePoint) {
  const Vector<3> reference(0.4, -0.3, 0.7);
  const auto a = moved(std::make_shared<CartesianInSpace>(), cartesian);
  AxisFrame at;
  at.point = -reference;
  SpaceScene scene({}, sphere(RADIUS, at), std::make_shared<CartesianInSpace>(), 0.3, GetParam().options);
  const auto place = [&](int k) {
    const Vector<3> v = spin(k);
    const Tensor<3> R = v.norm() > 0 ? turn_about(v, v.norm()) : Tensor<3>(Tensor<3>::Identity());
    Eigen::VectorXd q(6);
    q << center(k) + R * reference, v;
    return q;
  };
  const auto b = run(scene, place, [](int) {});
  ASSERT_FALSE(HasFatalFailure());
  EXPECT_LE(difference(a, b), GetParam().displacement);
  EXPECT_LE((a.force.back() - b.force.back()).head<3>().norm(), GetParam().force);
}

TEST_P(ToolsInSpaceAt, ATurnedFrame) {
  const Tensor<3> turn = turn_about({1, 2, -1}, 0.9);
  BlockOfTetrahedra block;
  block.turn = turn;
  const auto a = moved(std::make_shared<CartesianInSpace>(), cartesian);
  const auto b = moved(
      std::make_shared<CartesianInSpace>(),
      [&](int k) {
        Eigen::VectorXd q(6);
        q << turn * center(k),
            turn * spin(k); // of R turned, but for turn on the right, which a ball does not see
        return q;
      },
      block);
  ASSERT_FALSE(HasFatalFailure());
  const double apart = difference(a, b, turn);
  EXPECT_LE(apart, GetParam().displacement);
  EXPECT_LE((turn * a.force.back().head<3>() - b.force.back().head<3>()).norm(), GetParam().force);
  std::cout << "displacements differ by " << apart << " of the largest one\n";
}

TEST_P(ToolsInSpaceAt, PolarCoordinatesAboutALine) {
  const Vector<3> pivot(3, -4, 0.5);
  AxisFrame axis;
  axis.point = pivot;
  const auto a = moved(std::make_shared<CartesianInSpace>(), [](int k) {
    Eigen::VectorXd q = Eigen::VectorXd::Zero(6);
    q << center(k), 0, 0, 0.05 * k / STEPS;
    return q;
  });
  const auto b = moved(std::make_shared<PolarInSpace>(axis), [&](int k) {
    const Vector<3> arm = center(k) - pivot;
    return numbers({arm.head<2>().norm(), std::atan2(arm[1], arm[0]), arm[2], 0.05 * k / STEPS});
  });
  ASSERT_FALSE(HasFatalFailure());
  EXPECT_LE(difference(a, b), GetParam().displacement);
  EXPECT_NEAR(a.force.back()[2], b.force.back()[2], GetParam().force);
  EXPECT_NEAR(a.force.back()[5], b.force.back()[3], GetParam().force);
}

// Under motion; then with some coordinates under the forces that were read, from the fourth step on.
void ToolsInSpaceAt::check_duality(const std::shared_ptr<const Surface<3>>& surface, const Way& way,
                                   double mu, const std::vector<int>& loaded) const {
  const auto scene_of = [&] {
    return std::make_unique<SpaceScene>(BlockOfTetrahedra{}, surface, std::make_shared<CartesianInSpace>(),
                                        mu, GetParam().options);
  };
  const auto first = scene_of(), second = scene_of();
  const auto a = run(*first, way, [](int) {});
  SpaceScene& scene = *second;
  const auto b = run(scene, way, [&](int k) {
    if (k < 4) return;
    for (const int c : loaded) scene.tool->prescription().force(scene.names()[c], a.force[k - 1][c]);
  });
  ASSERT_FALSE(testing::Test::HasFatalFailure()) << loaded.size();
  for (int k = 0; k < STEPS; ++k)
    EXPECT_LE((b.force[k] - a.force[k]).cwiseAbs().maxCoeff(), GetParam().dual_force) << "step " << k;
  double worst = 0;
  for (int k = 0; k < STEPS; ++k) worst = std::max(worst, (b.q[k] - way(k + 1)).cwiseAbs().maxCoeff());
  EXPECT_LE(worst, GetParam().coordinate) << "of ways of 0.05 and more";
  EXPECT_LE(difference(a, b), GetParam().driven_displacement);
  for (const int c : loaded) EXPECT_GE(std::abs(a.force.back()[c]), 1e-4) << "no force, no test";
  std::cout << loaded.size() << " under force: coordinates recovered to " << worst << "\n";
}

/// A plate wider than the block: pressed, tilted, twisted, drawn sideways.
Eigen::VectorXd plate_way(int k) {
  const double t = 1. * k / STEPS, later = std::max(0., t - 0.3);
  return numbers({0.05 * later, 0.03 * later, -0.08 * t, 0.015 * later, -0.02 * later, 0.04 * later});
}

TEST_P(ToolsInSpaceAt, MotionAndForceExchangedWithoutFriction) {
  check_duality(sphere(RADIUS), cartesian, 0, {2});
}
TEST_P(ToolsInSpaceAt, MotionAndForceExchangedWhereAllStick) {
  const auto plate = std::make_shared<PlaneSurface>(Vector<3>(0, 0, 0), Vector<3>(0, 0, -1), 4);
  for (const auto& loaded :
       std::vector<std::vector<int>>{{2}, {0, 1, 2}, {2, 5}, {2, 3, 4}, {0, 1, 2, 3, 4, 5}})
    check_duality(plate, plate_way, 50, loaded);
}

// The tolerance is 1e-11 and, by default, 1e-4 of the load (0.08 of the ball, 0.45 of the plate).
INSTANTIATE_TEST_SUITE_P(T2T3, ToolsInSpaceAt,
                         testing::Values(Accuracy{"Tight", tight_options_in_space(), 1e-8, 1e-9, 1e-8, 1e-9,
                                                  1e-7},
                                         Accuracy{"Default", {}, 1e-5, 1e-9, 1e-5, 2e-5, 2e-4}),
                         [](const auto& info) { return info.param.name; });

// A plate is drawn along a block in several directions, the block turned with it: T/N = mu at every node, all forces turned alike.
TEST(ToolsInSpace, FrictionIsTheSameInEveryDirection) {
  const auto plate = std::make_shared<PlaneSurface>(Vector<3>(0, 0, 0), Vector<3>(0, 0, -1), 4);
  const auto xyz = std::make_shared<FormulaCoordinates<3>>("tool", std::vector<std::string>{"x", "y", "z"},
                                                           SpaceFormulas{"x", "y", "z"});
  Vector<3> first = Vector<3>::Zero();
  for (const double degrees : {0., 30., 90., 197.}) {
    const Tensor<3> turn = turn_about({0, 0, 1}, degrees * M_PI / 180);
    BlockOfTetrahedra block;
    block.nx = block.ny = 2;
    block.turn = turn;
    SpaceScene scene(block, plate, xyz, 0.2);
    scene.place(numbers({0, 0, 0.1}));
    scene.start();
    scene.contact->approach(0, "z", scene.u);
    const Vector<3> along = turn * Vector<3>::UnitX();
    for (int k = 1; k <= STEPS; ++k) {
      const double way = 0.1 * std::max(0, k - 3);
      scene.move(numbers({way * along[0], way * along[1], -0.02 * std::min(k, 3)}));
      scene.step((k - 1.) / STEPS, 1. / STEPS);
      ASSERT_FALSE(HasFatalFailure()) << degrees << " degrees";
    }
    const auto& nodes = scene.contact->accepted().contact.nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      EXPECT_EQ(nodes[i].state, NodeState::SLIDING);
      const Vector<3> Fi = turn.transpose() * scene.R.segment<3>(3 * scene.setup->model().candidates[i]);
      EXPECT_NEAR(Fi.head<2>().norm() / std::abs(Fi[2]), 0.2, 1e-10);
      EXPECT_GT(Fi[0], 0);
    }
    const Vector<3> F = turn.transpose() * scene.force_on_body(); // R: what the body needs
    if (degrees == 0) first = F;
    EXPECT_LE((F - first).norm(), 1e-10 * first.norm()) << degrees << " degrees";
  }
}
