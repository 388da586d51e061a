#include "unit/material/j2/point_walk.hpp"
#include <limits>

using namespace burnish;
using namespace burnish::test;

namespace {

const double UNLIMITED = std::numeric_limits<double>::infinity();
const Stress<2> BEFORE = {0.006, -0.003, 0.002, 0.004}; // dd_p

StepKinematics<2> step_of(const AnyGradient& F, StrainFrame frame = StrainFrame::MIDPOINT) {
  return kinematics(Tensor<2>::Identity(), F, frame);
}

StrainPath<2> path_of(const ElasticModuli& elastic, const StepKinematics<2>& kin,
                      const PathHistory<2>& history, PathDerivative<2>* derivative = nullptr) {
  return strain_path<2>(elastic, kin, deviatoric_stress<2>(elastic, kin.strain), history, derivative);
}

} // namespace

TEST(StrainPath, SubstepSharesSumToTheEndPoint) { // sum wq = 0, so sum wd = 1: the end point is exact
  for (int n = 1; n <= 20; ++n) {
    double sum = 0, first_half = 0;
    for (int k = 0; k < n; ++k) sum += curvature_share(k, n);
    for (int k = 0; k < n / 2; ++k) first_half += curvature_share(k, n);
    EXPECT_NEAR(sum, 0, 1e-16) << n << " substeps";
    if (n % 2 == 0) {
      EXPECT_NEAR(first_half, -0.125, 1e-15) << n << " substeps";
    } // f(f-1)/2 at f = 1/2
  }
}

TEST(StrainPath, WrittenFormula) { // st = s + wd De - wq Dp of ALGORITHMS.md (2.3)
  const ElasticModuli elastic = example_material().elastic;
  const StepKinematics<2> kin = step_of(tensor(1.004, 0.003, 0.001, 0.997));
  const double ra = 0.7, b = 2 * ra / (1 + ra);
  const StrainPath<2> path = path_of(elastic, kin, {BEFORE, ra, UNLIMITED});
  const Stress<2> increment = deviatoric_stress<2>(elastic, kin.strain);
  const Stress<2> before = deviatoric_stress<2>(elastic, ra * BEFORE);
  const int n = 4;
  for (int k = 0; k < n; ++k) {
    const double f0 = double(k) / n, f1 = double(k + 1) / n, wq = b / 2 * (f1 * (f1 - 1) - f0 * (f0 - 1));
    const Stress<2> expected = (1. / n + wq) * increment - wq * before;
    expect_close(path.elastic_increment / n + curvature_share(k, n) * path.curvature, expected,
                 increment.norm(), 1e-15, "trial increment");
  }
}

TEST(StrainPath, PassesThroughTheMeanRatesOfBothSteps) {
  // e(-1/ra) = -dd_p: the parabola through the last step's start, its end and this step's end
  const ElasticModuli elastic = example_material().elastic;
  const StepKinematics<2> kin = step_of(tensor(1.004, 0.003, 0.001, 0.997));
  for (double ra : {0.5, 1.0, 2.0}) {
    const StrainPath<2> path = path_of(elastic, kin, {BEFORE, ra, UNLIMITED});
    const double f = -1 / ra;
    expect_close(f * path.elastic_increment + 0.5 * f * (f - 1) * path.curvature,
                 -deviatoric_stress<2>(elastic, BEFORE), path.elastic_increment.norm(), 1e-14,
                 "start of the last step");
  }
}

TEST(StrainPath, StraightWithoutHistoryOrForASteadyRate) {
  const ElasticModuli elastic = example_material().elastic;
  const StepKinematics<2> kin = step_of(tensor(1.004, 0.003, 0.003, 0.997));
  EXPECT_EQ(path_of(elastic, kin, {BEFORE, 0, 1.5}).curvature.norm(), 0); // no last step
  EXPECT_EQ(path_of(elastic, kin, {BEFORE, 1, 0}).curvature.norm(), 0);   // limit 0
  const StrainPath<2> steady = path_of(elastic, kin, {kin.strain / 2, 2, UNLIMITED});
  EXPECT_LE(steady.curvature.norm(), 1e-15 * steady.elastic_increment.norm());
}

TEST(StrainPath, LimiterBoundsTheCurvature) {
  const ElasticModuli elastic = example_material().elastic;
  const StepKinematics<2> kin = step_of(tensor(1.0004, 0.0003, 0.0001, 0.9997)); // a tenth of the last step
  const double limit = 1.5, b = 1;
  const Stress<2> change = kin.strain - BEFORE;
  const double size = std::sqrt(contract<2>(kin.strain, kin.strain) / contract<2>(change, change));
  ASSERT_LT(limit * size, 1); // the limiter is active
  expect_close(path_of(elastic, kin, {BEFORE, 1, limit}).curvature,
               deviatoric_stress<2>(elastic, b * limit * size * change), elastic.G * 1e-4, 1e-12,
               "curvature");
  const StepKinematics<2> rest = step_of(Tensor<2>::Identity());
  EXPECT_EQ(path_of(elastic, rest, {BEFORE, 1, limit}).curvature.norm(), 0); // no strain, no curvature
}

TEST(StrainPath, EndFrameTurnsTheLastIncrement) {
  const ElasticModuli elastic = example_material().elastic;
  const Tensor<2> F = rotation(0.2) * tensor(1.004, 0.003, 0.003, 0.997);
  const StepKinematics<2> kin = step_of(F, StrainFrame::END);
  const double alpha = 2 * std::atan(0.5 * kin.spin);
  const Stress<2> expected = deviatoric_stress<2>(elastic, kin.strain - turned(BEFORE, rotation(alpha)));
  expect_close(path_of(elastic, kin, {BEFORE, 1, UNLIMITED}).curvature, expected, expected.norm(), 1e-13,
               "curvature");
}

TEST(StrainPath, DerivativeAgainstFiniteDifferences) {
  const ElasticModuli elastic = example_material().elastic;
  const Gradient<2> F = gradient(rotation(0.05) * tensor(1.004, 0.003, 0.001, 0.997), 0.998);
  for (StrainFrame frame : {StrainFrame::MIDPOINT, StrainFrame::END})
    for (double limit : {UNLIMITED, 1.5, 0.5, 0.0}) {
      SCOPED_TRACE("limit " + std::to_string(limit));
      const PathHistory<2> history{BEFORE, 0.8, limit};
      PathDerivative<2> derivative;
      const StepKinematics<2> kin = step_of(F, frame);
      path_of(elastic, kin, history, &derivative);
      const IncrementByF<2> by_F = finite_increment_by_F(kin);
      for (int c = 0; c < 5; ++c) {
        const auto path = [&](double t) {
          const StrainPath<2> p = path_of(elastic, step_of(F + t * Gradient<2>::Unit(c), frame), history);
          Eigen::Matrix<double, 8, 1> both;
          both << p.elastic_increment, p.curvature;
          return both;
        };
        Eigen::Matrix<double, 8, 1> computed;
        computed << derivative.elastic_increment * by_F.col(c), derivative.curvature * by_F.col(c);
        expect_close(computed, finite_difference(path, 0, 1e-5), elastic.G, 1e-8,
                     "d(elastic increment, curvature)");
      }
    }
}
