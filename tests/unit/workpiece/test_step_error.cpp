// The estimate of what the length of the steps costs: order, and where there is none.
#include "unit/material/j2/point_walk.hpp"
#include "unit/workpiece/patch.hpp"
#include "workpiece/point_fields.hpp"
#include "workpiece/step_error.hpp"

using namespace burnish;
using namespace burnish::test;

namespace {

// A patch is sheared along a circle of strains in n steps after a stretch that yields. Returns the estimate of all steps.
StepErrorState walk(int n, StressUpdate update, double& plastic_strain_eq, double size = 0.1) {
  UpdateOptions options;
  options.update = update;
  Workpiece<2> body(patch(3, 1), j2_law<2>(example_material()), options);
  StepErrorState error;
  for (int k = 0; k <= n; ++k) {
    const double angle = 1.5 * k / n;
    const double a = size * std::cos(angle), b = size * std::sin(angle);
    const Tensor<2> F = tensor(1 + a, b, b, 1 - a);
    EXPECT_EQ(body.update(homogeneous(body.discretization(), F), 1, 0).status, UpdateStatus::OK);
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
