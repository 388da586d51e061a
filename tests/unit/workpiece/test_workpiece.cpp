// The step of a workpiece: update, substeps, failures, bad input.
#include "unit/material/j2/point_walk.hpp"
#include "unit/workpiece/patch.hpp"
#include <limits>

using namespace burnish;
using namespace burnish::test;

namespace {

const double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();

Workpiece<2> workpiece(int nodes = 3, UpdateOptions options = {}) {
  return {patch(nodes, 1), j2_law<2>(example_material()), options};
}

UpdateOptions with_update(StressUpdate update) {
  UpdateOptions options;
  options.update = update;
  return options;
}

} // namespace

TEST(Workpiece, StartsUndeformed) {
  const Workpiece<2> body = workpiece(6);
  EXPECT_EQ(body.state().displacement, Eigen::VectorXd::Zero(50));
  EXPECT_EQ(body.state().F.size(), 24u * 5);
  for (int p = 0; p < 24; ++p)
    EXPECT_EQ(std::vector<double>(&body.state().F[5 * p], &body.state().F[5 * p] + 5),
              std::vector<double>({1, 0, 0, 1, 1}));
  EXPECT_EQ(body.internal_force(), Eigen::VectorXd::Zero(50));
  EXPECT_EQ(body.state().dt, 0);
  EXPECT_TRUE(same(body.state(), body.state_old()));
}

TEST(Workpiece, UpdateIsThePointFunctionWithTheRatioOfTheSteps) {
  for (StressUpdate update : {StressUpdate::SUBSTEPPED, StressUpdate::SINGLE, StressUpdate::FORWARD_EULER})
    for (StrainFrame frame : {StrainFrame::MIDPOINT, StrainFrame::END}) {
      UpdateOptions options = with_update(update);
      options.strain_frame = frame;
      Workpiece<2> body = workpiece(3, options);
      PointWalk step;
      step.frame = frame;
      const Tensor<2> path[] = {tensor(1.01, 0.002, 0, 1), tensor(1.013, 0.01, 0.004, 1),
                                tensor(1.01, 0.02, 0.01, 1.01)};
      const double dt[] = {2, 1, 3};
      for (int k = 0; k < 3; ++k) {
        const int substeps = substeps_needed<2>(step.material, options, step.trial(path[k]),
                                                step.old.plastic_strain_eq, step.old.plastic);
        step.scheme = {update, options.path_limit, k ? dt[k] / dt[k - 1] : 0, substeps};
        ASSERT_EQ(body.update(homogeneous(body.discretization(), path[k]), dt[k], 0).status,
                  UpdateStatus::OK);
        body.accept();
        step.advance(path[k]);
        for (int p : {0, 7}) {
          expect_close(stress_at(body.state(), p), step.old.stress, 1e8, 1e-11, "stress");
          EXPECT_NEAR(plastic_strain_eq_at(body.state(), p), step.old.plastic_strain_eq, 1e-14);
          EXPECT_EQ(body.state().plastic[p] != 0, step.old.plastic);
          EXPECT_EQ(body.state().dt, dt[k]);
        }
      }
      EXPECT_GT(step.old.plastic_strain_eq, 0.005);
    }
}

TEST(Workpiece, UpdateDependsOnStateOldOnly) {
  Workpiece<2> body = workpiece(6), fresh = workpiece(6);
  const Eigen::VectorXd first = bent(body.discretization(), 1, 0.005),
                        second = bent(body.discretization(), 1, 0.012);
  for (Workpiece<2>* w : {&body, &fresh}) {
    w->update(first, 1, 0);
    w->accept();
  }
  body.update(3 * second, 1, 0); // something else in between
  body.update(second, 1, 0);
  fresh.update(second, 1, 0);
  EXPECT_TRUE(same(body.state(), fresh.state()));
  EXPECT_FALSE(same(body.state(), body.state_old()));
}

TEST(Workpiece, SubstepsGrowThenFreeze) {
  Workpiece<2> body = workpiece();
  const auto stress_after = [&](std::vector<double> stretches, std::vector<int> iterations) {
    for (std::size_t k = 0; k < stretches.size(); ++k)
      body.update(homogeneous(body.discretization(), tensor(1 + stretches[k], 0.5 * stretches[k], 0, 1)), 1,
                  iterations[k]);
    return stress_at(body.state(), 0);
  };
  stress_after({0.008}, {0}); // some plastic flow, in another direction than the next step would have it
  body.accept();
  const double small = 0.009, large = 0.03; // 3 and 20 substeps
  const Stress<2> coarse_small = stress_after({small}, {0}), fine_large = stress_after({large}, {0});
  EXPECT_EQ(stress_after({small, large}, {0, 1}), fine_large);   // grows before iteration 3
  EXPECT_NE(stress_after({small, large}, {0, 3}), fine_large);   // frozen at 3 substeps
  EXPECT_NE(stress_after({large, small}, {0, 1}), coarse_small); // never shrinks within the step
  EXPECT_EQ(stress_after({large, small}, {0, 0}), coarse_small); // a new step begins
}

TEST(Workpiece, FrozenSubstepsKeepTheStressContinuous) {
  // across the strain where one more substep is asked for
  Workpiece<2> body = workpiece();
  const J2Parameters material = example_material();
  const double yield = material.yield_stress(0).value;
  const double stress_per_stretch = equivalent<2>(deviatoric_stress<2>(material.elastic, {1, 0, 0, 0}));
  const double jump_at = 4 * 0.3 * yield / stress_per_stretch; // 4 -> 5 substeps
  const auto stress = [&](double stretch, int iteration) {
    const double F = (2 + stretch) / (2 - stretch); // midpoint strain = stretch
    body.update(homogeneous(body.discretization(), tensor(F, 0, 0, 1)), 1, iteration);
    return stress_at(body.state(), 0);
  };
  WorkpieceState<2> start = body.state();
  for (int p = 0; p < 8; ++p) start.stress[4 * p + 3] = 0.5 * yield; // so that the path turns
  body.set_state(start);
  const double small = 1e-9 * jump_at;
  const double restarted = (stress(jump_at + small, 0) - stress(jump_at - small, 0)).norm();
  stress(jump_at - small, 0);
  const double frozen = (stress(jump_at + small, 3) - stress(jump_at - small, 3)).norm();
  EXPECT_GT(restarted, 1e-4 * yield);
  EXPECT_LT(frozen, 1e-7 * yield);
}

TEST(Workpiece, PointThatFlowedRunsItsSubstepsWhenTheTrialIsElastic) {
  Workpiece<2> body = workpiece();
  const auto update = [&](double xx) {
    body.update(homogeneous(body.discretization(), tensor(xx, 0, 0, 1)), 1, 0);
  };
  update(1.01);
  body.accept();
  body.options().path_limit = std::numeric_limits<double>::infinity();
  update(1.0099); // back a little, but the quadratic path goes on first
  EXPECT_TRUE(body.state().plastic[0]);
  body.options().path_limit = 0;
  update(1.0099);
  EXPECT_FALSE(body.state().plastic[0]);
}

TEST(Workpiece, ReportsInvertedElements) {
  for (int nodes : {3, 6}) {
    Workpiece<2> body = workpiece(nodes);
    const Discretization<2>& mesh = body.discretization();
    UpdateResult result = body.update(homogeneous(mesh, tensor(-0.5, 0, 0, 2)), 1, 0);
    EXPECT_EQ(result.status, UpdateStatus::INVERTED_ELEMENT);
    EXPECT_EQ(result.point, 0);
    EXPECT_NEAR(result.value, -1, 1e-12);
    result = body.update(homogeneous(mesh, tensor(-0.5, 0, 0, -3)), 1, 0); // det F = 1.5, det F_mid = -0.25
    EXPECT_EQ(result.status, UpdateStatus::INVERTED_ELEMENT);
    EXPECT_NEAR(result.value, -0.25, 1e-12);
    Eigen::VectorXd u = Eigen::VectorXd::Zero(mesh.num_dofs());
    u[2 * 8 + 1] = -2; // the corner vertex 8 pulled through the body: only elements 6 and 7 have it
    result = body.update(u, 1, 0);
    EXPECT_EQ(result.status, UpdateStatus::INVERTED_ELEMENT);
    EXPECT_EQ(result.point / mesh.points_per_element, 6);
    EXPECT_LE(result.value, 0);
    result = body.update(0 * u, 1, 0); // usable again
    EXPECT_EQ(result.status, UpdateStatus::OK);
    EXPECT_EQ(result.point, -1);
  }
}

// Whatever fails, at the end of the step or in the law: the first point in order, in any place of what is updated together.
TEST(Workpiece, ReportsTheFirstPointThatFails) {
  constexpr int COUNT = 70;
  std::vector<double> X;
  std::vector<int> connectivity;
  for (int e = 0; e < COUNT; ++e) // triangles that share no node
    for (const double x : {2. * e, 0., 2. * e + 1, 0., 2. * e, 1.}) X.push_back(x);
  for (int k = 0; k < 3 * COUNT; ++k) connectivity.push_back(k);
  Workpiece<2> body(triangles(3, X, connectivity), j2_law<2>(example_material()));
  const auto deform = [&](Eigen::VectorXd& u, int e, const Tensor<2>& F) {
    const Tensor<2> H = F - Tensor<2>::Identity();
    u.segment<6>(6 * e) << 0, 0, H.col(0), H.col(1);
  };
  for (const int in_law : {0, 2, 3, 5, 63, 64, 68, 69})
    for (const int at_end : {0, 1, 3, 6, 62, 63, 65, 69}) {
      if (in_law == at_end) continue;
      Eigen::VectorXd u = Eigen::VectorXd::Zero(6 * COUNT);
      deform(u, in_law, tensor(-0.5, 0, 0, -3)); // det F = 1.5, det F_mid = -0.25
      deform(u, at_end, tensor(-0.5, 0, 0, 2));  // det F = -1
      const UpdateResult result = body.update(u, 1, 0);
      EXPECT_EQ(result.status, UpdateStatus::INVERTED_ELEMENT);
      EXPECT_EQ(result.point, std::min(in_law, at_end));
      EXPECT_NEAR(result.value, in_law < at_end ? -0.25 : -1, 1e-12);
    }
}

TEST(Workpiece, ReportsNotFiniteDisplacements) {
  Workpiece<2> body = workpiece();
  Eigen::VectorXd u = Eigen::VectorXd::Zero(18);
  u[2 * 8] = NOT_A_NUMBER;
  UpdateResult result = body.update(u, 1, 0);
  EXPECT_EQ(result.status, UpdateStatus::NOT_FINITE);
  EXPECT_EQ(result.point, 6);
  u[2 * 8] = 1e308;
  EXPECT_EQ(body.update(u, 1, 0).status, UpdateStatus::NOT_FINITE);
  std::vector<double> X = {0, 0, 1, 0, 0, 1, 5, 5}; // node 3 belongs to no element
  Workpiece<2> loose(triangles(3, X, {0, 1, 2}), j2_law<2>(example_material()));
  Eigen::VectorXd v = Eigen::VectorXd::Zero(8);
  v[7] = NOT_A_NUMBER;
  result = loose.update(v, 1, 0);
  EXPECT_EQ(result.status, UpdateStatus::NOT_FINITE);
  EXPECT_EQ(result.point, -1);
}

TEST(Workpiece, ErrorsOfConstruction) {
  const auto good = j2_law<2>(example_material());
  const auto expect_mesh = [&](auto change, const std::string& text) {
    Discretization<2> mesh = patch(3, 1);
    change(mesh);
    expect_invalid([&] { Workpiece<2>(mesh, good); }, "Workpiece: " + text);
  };
  expect_mesh([](auto& m) { m.num_elements = 0; }, "num_elements = 0, expected > 0");
  expect_mesh([](auto& m) { m.nodes_per_element = 2; }, "nodes_per_element = 2, expected > Dim");
  expect_mesh([](auto& m) { m.points_per_element = 0; }, "points_per_element = 0, expected > 0");
  expect_mesh([](auto& m) { m.X.pop_back(); }, "size of X = 17");
  expect_mesh([](auto& m) { m.connectivity.pop_back(); }, "size of connectivity = 23");
  expect_mesh([](auto& m) { m.weight.pop_back(); }, "size of weight = 7");
  expect_mesh([](auto& m) { m.shape_grad.pop_back(); }, "size of shape_grad = 47");
  expect_invalid([&] { Workpiece<2>(patch(3, 1), nullptr); }, "Workpiece: there is no law");
  UpdateOptions options;
  options.min_substeps = 0;
  expect_invalid([&] { workpiece(3, options); }, "Workpiece: min_substeps = 0, expected >= 1");
}

TEST(Workpiece, ErrorsOfUpdate) {
  Workpiece<2> body = workpiece();
  const Eigen::VectorXd u = Eigen::VectorXd::Zero(18);
  expect_invalid([&] { body.update(Eigen::VectorXd::Zero(17), 1, 0); },
                 "Workpiece::update: size of displacement = 17, expected num_dofs");
  expect_invalid([&] { body.update(u, 0, 0); }, "Workpiece::update: dt = 0, expected finite > 0");
  expect_invalid([&] { body.update(u, 1, -1); }, "Workpiece::update: iteration = -1, expected >= 0");
  body.options().path_limit = -1;
  expect_invalid([&] { body.update(u, 1, 0); }, "Workpiece::update: path_limit = -1, expected >= 0");
}
