// Jumps to equilibria that were not near: what their viscosity has dissipated (ALGORITHMS.md 9.4).
#include "base/sentence.hpp"
#include "diagnosis/observers.hpp"
#include <iomanip>

namespace burnish {
namespace {

constexpr Bounds JUMPS{0, 0.05}; // dissipated by jumps over the tools' work

template <int Dim> class Jumps final : public ObserverOf<Jumps<Dim>, Dim> {
public:
  void look(const AcceptedStep<Dim>& step, FindingList& findings) override {
    if (!(step.jumped > 0)) return;
    const double part = step.drives > 0 ? step.jumped / step.drives : 1;
    findings.largest("jumps", part);
    Finding* finding = findings.beyond("jumps", "", part, JUMPS, step.t);
    if (finding)
      finding->text =
          sentence("the workpiece has jumped, events \"jump\", to equilibria that were not near: this takes ",
                   std::setprecision(2), 100 * part, " % of the tools' work, t = ", step.t,
                   ": what follows depends on how it got there; jumps=0 of stepcontrol stops instead");
  }
};

} // namespace

BURNISH_OBSERVER(jumps, Jumps)

} // namespace burnish
