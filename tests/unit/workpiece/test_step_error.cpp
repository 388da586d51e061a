// The estimate of what the length of the steps costs: order, and where there is none.
#include "unit/material/j2/point_walk.hpp"
#include "unit/workpiece/patch.hpp"
#include "workpiece/point_fields.hpp"
#include "workpiece/step_error.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

// The law of a script: the material's single return, plastic strain times a factor.
void give(Workpiece<2>& body, double factor) {
  const int points = body.discretization().num_points(),
            place = body.law().internal_place("plastic_strain_eq", 0, "test");
  Eigen::MatrixXd stress(points, 4);
  Eigen::VectorXd strain(points);
  UpdateOptions single;
  single.update = StressUpdate::SINGLE;
  std::vector<double> internal(static_cast<std::size_t>(body.law().internal_variables().size()));
  for (int p = 0; p < points; ++p) {
    const PointStep<2> step = body.point_step(p);
    PointTrial trial;
    PointUpdate<2> now;
    now.internal = internal.data();
    EXPECT_EQ(body.law().update({step.old, step.F, step.ratio, 0, single}, trial, now).status,
              UpdateStatus::OK);
    stress.row(p) = now.stress.transpose();
    strain[p] = step.old.internal[place] + factor * (internal[place] - step.old.internal[place]);
  }
  for (int k = 0; k < 4; ++k) body.given("test").stress(k, stress.col(k));
  body.given("test").internal("plastic_strain_eq", 0, strain);
}

// A patch is sheared along a circle of strains in n steps after a stretch that yields. Returns the estimate of all steps.
// factor: > 0: by a law of the script, see give
StepErrorState walk(int n, StressUpdate update, double& plastic_strain_eq, double size = 0.1,
                    double factor = 0) {
  UpdateOptions options;
  options.update = update;
  Workpiece<2> body(patch(3, 1), j2_law<2>(example_material()), options);
  body.set_user_defined(factor > 0);
  StepErrorState error;
  for (int k = 0; k <= n; ++k) {
    const double angle = 1.5 * k / n;
    const double a = size * std::cos(angle), b = size * std::sin(angle);
    const Tensor<2> F = tensor(1 + a, b, b, 1 - a);
    EXPECT_EQ(body.update(homogeneous(body.discretization(), F), 1, 0).status, UpdateStatus::OK);
    if (factor > 0) give(body, factor);
    add_step_error(body, error);
    if (k == 0) {
      EXPECT_EQ(error.estimate(), -1) << "no step before";
    }
    body.accept();
    if (k == 2 && size > 1e-3) error = {}; // the corner from the stretch to the circle
  }
  plastic_strain_eq = internal_field(body, "plastic_strain_eq")[0];
  return error;
}

} // namespace

TEST(StepError, FallsWithTheSteps) {
  for (const StressUpdate update : {StressUpdate::SUBSTEPPED, StressUpdate::SINGLE}) {
    double ep = 0;
    const double coarse = walk(20, update, ep).estimate(), fine = walk(40, update, ep).estimate(),
                 finer = walk(80, update, ep).estimate();
    EXPECT_GT(coarse, 1e-4);
    EXPECT_GT(coarse / fine, 1.6) << "at least nearly first order";
    EXPECT_GT(fine / finer, 1.6);
  }
}

TEST(StepError, NoneWithoutFlow) {
  double ep = 0;
  EXPECT_EQ(walk(10, StressUpdate::SUBSTEPPED, ep, 1e-4).estimate(), -1) << "elastic";
  EXPECT_EQ(ep, 0);
  EXPECT_EQ(walk(10, StressUpdate::FORWARD_EULER, ep).estimate(), -1);
}

TEST(StepError, OfAScriptWhoseLawIsTheMaterialsOwn) {
  double ep = 0;
  const double own = walk(20, StressUpdate::SINGLE, ep).estimate();
  EXPECT_NEAR(walk(20, StressUpdate::SUBSTEPPED, ep, 0.1, 1).estimate(), own, 1e-12 * own);
  EXPECT_EQ(walk(20, StressUpdate::SUBSTEPPED, ep, 0.1, 1.3).estimate(), -1) << "another law";
}
