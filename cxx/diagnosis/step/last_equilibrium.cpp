// Behind a limit load: the last equilibrium, with force and place of every coordinate under a force other than zero; if there
// is none, of those under motion.
#include "diagnosis/observers.hpp"

namespace burnish {
namespace {

template <int Dim> class LastEquilibrium final : public ObserverOf<LastEquilibrium<Dim>, Dim> {
public:
  void explain(const FailedStep<Dim>& step, std::vector<Failure>& causes) const override {
    if (!step.found.limit_load() || !(step.last_dt > 0)) return;
    const PrescribedValues& prescribed = step.before;
    causes.push_back(Cause::LAST_EQUILIBRIUM);
    causes.back().t = step.t;
    bool loaded = false;
    for (std::size_t k = 0; k < prescribed.is_motion.size(); ++k)
      loaded = loaded || (prescribed.is_motion[k] == 0 && prescribed.value[k] != 0);
    for (int k = 0; k < static_cast<int>(prescribed.is_motion.size()); ++k) {
      if (step.generalized_force[k] == 0 || prescribed.is_motion[k] == (loaded ? 1 : 0)) continue;
      if (loaded && prescribed.value[k] == 0) continue;
      Failure failure(Cause::EQUILIBRIUM_OF);
      failure.coordinate = k;
      failure.value = step.state.q[k];
      failure.allowed = step.generalized_force[k];
      causes.push_back(failure);
    }
  }
};

} // namespace

BURNISH_OBSERVER(last_equilibrium, LastEquilibrium)

} // namespace burnish
