// A yield stress that is never reached (ALGORITHMS.md 17.1).
#include "diagnosis/known_law.hpp"
#include "diagnosis/observers.hpp"
#include "material/stress_algebra.hpp"
#include <cmath>

namespace burnish {
namespace {

constexpr double PLAUSIBLE = 1e-2; // von Mises over yield stress: below, the workpiece is meant to be elastic

template <int Dim> class UnusedYield final : public ObserverOf<UnusedYield<Dim>, Dim> {
public:
  BURNISH_REMEMBERS(m_largest)
  void look(const AcceptedStep<Dim>& step, FindingList&) override {
    const MaterialLaw<Dim>* law = known_law(step.workpiece);
    if (!law || !step.first_of_ten()) return;
    const double yield = law->yield_stress(0).value;
    double squared = 0;
    for (int p = 0; p < step.workpiece->discretization().num_points(); ++p) {
      const Stress<Dim> s = deviator<Dim>(Stress<Dim>(point_state(step.workpiece->state_old(), p).stress));
      squared = std::max(squared, 1.5 * contract<Dim>(s, s));
    }
    if (yield > 0) m_largest = std::max(m_largest, std::sqrt(squared) / yield);
  }
  void end(const EndedRun<Dim>& run, std::vector<Statement>& list) const override {
    const MaterialLaw<Dim>* law = known_law(run.step.workpiece);
    if (!law || flowed(*run.step.workpiece)) return;
    if (!(m_largest > PLAUSIBLE)) return;
    list.push_back({StatementKind::NOT_NEEDED, "yield", m_largest, 35,
                    "nothing yielded, the von Mises stress reaches " + short_number(m_largest) +
                        " of the yield stress: an elastic workpiece, sigY=1e30, gives the same"});
  }

private:
  double m_largest = 0; // von Mises stress over the initial yield stress
};

} // namespace

BURNISH_OBSERVER(unused_yield, UnusedYield)

} // namespace burnish
