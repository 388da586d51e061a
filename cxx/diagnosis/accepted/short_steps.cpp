// Steps shorter than the error that is asked for (ALGORITHMS.md 17.1).
#include "diagnosis/observers.hpp"

namespace burnish {
namespace {

constexpr double FINE = 0.1; // error of the steps over the accuracy asked

template <int Dim> class ShortSteps final : public ObserverOf<ShortSteps<Dim>, Dim> {
public:
  void end(const EndedRun<Dim>& run, std::vector<Statement>& list) const override {
    const StepAccuracy& steps = run.accuracy;
    if (!(steps.error < FINE * steps.asked) || !steps.longest) return;
    list.push_back({StatementKind::NOT_NEEDED, "steps", steps.error / steps.asked, 60,
                    "the steps are finer than needed: their error is about " + short_number(steps.error) +
                        ", " + short_number(steps.asked) +
                        (steps.given ? " is asked for" : " passes without a warning") +
                        ": a larger dtmax= is enough"});
  }
};

} // namespace

BURNISH_OBSERVER(short_steps, ShortSteps)

} // namespace burnish
