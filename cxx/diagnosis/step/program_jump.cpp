// A program that moves a tool, or changes its force, at once: halving the step does not make it less.
#include "diagnosis/observers.hpp"
#include "diagnosis/step/leaps.hpp"
#include <cmath>

namespace burnish {
namespace {

constexpr double SHORT = 1e-3;      // of the largest step: changes of motion and force are small by then
constexpr double MOTION = 1e-2;     // of a tool's points that is no jump, over the spacing of candidates
constexpr double MUCH_FORCE = 1e-2; // change over the larger of both forces

template <int Dim> class ProgramJump final : public ObserverOf<ProgramJump<Dim>, Dim> {
public:
  void explain(const FailedStep<Dim>& step, std::vector<Failure>& causes) const override {
    const Eigen::VectorXd& q = step.state.q;
    if (step.dt > SHORT * step.largest_dt || q.size() != step.prescribed.value.size()) return;
    const auto poses = step.setup.model().poses(q);
    for (int k = 0; k < static_cast<int>(q.size()); ++k) {
      const double leap = step.prescribed.value[k] - q[k];
      if (!step.prescribed.is_motion[k] ||
          std::abs(leap) * lever(step.setup.model(), poses, k) < MOTION * step.setup.body().spacing)
        continue;
      causes.push_back(of_coordinate(Cause::PROGRAM_MOVES, k, leap, q[k], step.t));
      return;
    }
    explain_force(step, causes);
  }

private:
  static Failure of_coordinate(Cause cause, int k, double value, double before, double t) {
    Failure failure(cause);
    failure.coordinate = k;
    failure.value = value;
    failure.allowed = before;
    failure.t = t;
    return failure;
  }
  // Formulas are judged by nobody.
  static void explain_force(const FailedStep<Dim>& step, std::vector<Failure>& causes) {
    const Eigen::VectorXd &now = step.prescribed.value, &before = step.before.value;
    if (now.size() != before.size()) return;
    for (int k = 0; k < static_cast<int>(now.size()); ++k) {
      if (step.prescribed.is_motion[k] || step.before.is_motion[k]) continue;
      if (!step.prescribed.formula.empty() && step.prescribed.formula[k]) continue;
      const double largest = std::max(std::abs(now[k]), std::abs(before[k]));
      if (!(std::abs(now[k] - before[k]) > MUCH_FORCE * largest)) continue;
      causes.push_back(of_coordinate(Cause::PROGRAM_FORCES, k, now[k], before[k], step.t));
      return;
    }
  }
};

} // namespace

BURNISH_OBSERVER(program_jump, ProgramJump)

} // namespace burnish
