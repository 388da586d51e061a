// A soft hold that tools and supports do not relieve.
#include "base/sentence.hpp"
#include "diagnosis/observers.hpp"

namespace burnish {
namespace {

// What the hold carries at the end, or carried when it ended, over the load; far: at the end of the program only, since behind the
// end of a hold the forces balance without it.
constexpr Bounds CARRIES{1e-3}, AT_THE_END{1e-3, 0.05};

template <int Dim> class HoldCarries final : public ObserverOf<HoldCarries<Dim>, Dim> {
public:
  void look(const AcceptedStep<Dim>& step, FindingList& findings) override {
    findings.withdraw("hold", ""); // it may hand over its load yet
    const bool acts = step.hold.force.size() > 0;
    Finding* finding = findings.beyond("hold", "", step.hold.share, acts ? AT_THE_END : CARRIES, step.t);
    if (!finding) return;
    finding->text =
        sentence(acts ? "the hold, which ends at t = " : "when the hold ended at t = ", step.hold.until,
                 acts ? ", carries " : " it still carried ", step.hold.share,
                 " of the load: tools and supports do not hold the workpiece alone");
  }
};

} // namespace

BURNISH_OBSERVER(hold_carries, HoldCarries)

} // namespace burnish
