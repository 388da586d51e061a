// Implicit and event stepping go to the same limit as the step shrinks: a coarse example 1, P2 24/5 cells.
#include "support/rolling.hpp"
#include <iostream>

using namespace burnish;
using namespace burnish::test;

namespace {

/// Depth r - r(0), theta and Q_phi at the ten output times, 10 x 3.
Eigen::MatrixXd history(Scheme scheme, double dt) {
  Rolling rolling(24, 5);
  StepControlOptions options;
  options.dt_max = dt;
  options.steps_per_width = 0;
  for (int i = 1; i <= 10; ++i) options.output_times.push_back(0.1 * i);
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(10, 3);
  const double start = rolling.scene.tool->q()[0];
  double now = 0;
  const ProgramAt program = [&, set = rolling.program()](double t) { set(now = t); };
  StepperOptions stepping;
  stepping.scheme = scheme;
  Stepper<2> stepper(rolling.scene.contact(), rolling.scene.body, rolling.scene.diagnosis,
                     StepControl(0, options), stepping);
  const Task end = run(rolling.scene, stepper, program, [&] {
    const int i = static_cast<int>(std::lround(10 * now)) - 1;
    if (i < 0 || std::abs(now - options.output_times[i]) > 1e-9) return;
    auto& tool = *rolling.scene.tool;
    rows.row(i) << tool.q()[0] - start, tool.q()[2], tool.generalized_force()[1];
  });
  EXPECT_EQ(end, Task::FINISHED) << stepper.reason();
  return rows;
}

/// Mean difference over the program, relative to the final values: depth, rotation, moment.
Eigen::RowVectorXd difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  const Eigen::RowVectorXd mean = (a - b).cwiseAbs().colwise().mean();
  return mean.cwiseQuotient(b.row(9).cwiseAbs());
}

} // namespace

TEST(TwoIntegrators, SameLimit) {
  double first = 0, before = 0;
  for (const double dt : {0.05, 0.025, 0.0125, 0.00625}) {
    const Eigen::MatrixXd implicit = history(Scheme::IMPLICIT, dt), event = history(Scheme::EVENT, dt);
    const Eigen::RowVectorXd mean = difference(implicit, event);
    const Eigen::RowVectorXd end =
        (implicit - event).row(9).cwiseAbs().cwiseQuotient(event.row(9).cwiseAbs());
    std::cout << "dt " << dt << ": depth, rotation, moment differ by " << mean << " (mean), " << end
              << " (end)\n";
    EXPECT_LE(mean.maxCoeff(), 0.02) << "dt " << dt;
    if (dt < 0.03) {
      EXPECT_LE(end.maxCoeff(), 0.02) << "dt " << dt;
    }
    if (before > 0) {
      EXPECT_LE(mean.maxCoeff(), 0.95 * before) << "halving the step to " << dt << " reduces the difference";
    }
    before = mean.maxCoeff();
    if (first == 0) first = before;
  }
  EXPECT_LE(before, 0.5 * first);
  EXPECT_LE(before, 2e-3);
}
