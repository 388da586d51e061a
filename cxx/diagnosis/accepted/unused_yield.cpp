// A yield stress that is never reached (ALGORITHMS.md 17.1).
#include "diagnosis/known_law.hpp"
#include "diagnosis/observers.hpp"
#include "material/stress_algebra.hpp"
#include <cmath>

namespace burnish {
namespace {

constexpr double PLAUSIBLE = 1e-2; // von Mises over yield stress: below, the workpiece is meant to be elastic

constexpr double MISTAKEN = 1,
                 ON_PURPOSE = 1e5; // yield stress over Young's modulus: a unit that is another one

template <int Dim> double young_modulus(const MaterialLaw<Dim>& law) {
  const auto moduli = law.moduli();
  const double K = moduli.at("K"), G = moduli.at("G");
  return 9 * K * G / (3 * K + G);
}

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
    const double ratio = law->yield_stress(0).value / young_modulus(*law);
    if (ratio > MISTAKEN && ratio < ON_PURPOSE)
      list.push_back(
          {StatementKind::NOT_NEEDED, "yield stress", ratio, 35,
           "the yield stress is " + short_number(ratio) +
               " times Young's modulus: is its unit another one? An elastic workpiece has sigY=1e30"});
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
