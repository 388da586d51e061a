// Stress beyond the yield surface (ALGORITHMS.md 16.5).
#include "base/sentence.hpp"
#include "diagnosis/observers.hpp"
#include "workpiece/point_fields.hpp"

namespace burnish {
namespace {

constexpr Bounds YIELD{1e-2, 0.1}; // distance from the surface over the yield stress

template <int Dim> class YieldCheck final : public ObserverOf<YieldCheck<Dim>, Dim> {
public:
  void look(const AcceptedStep<Dim>& step, FindingList& findings) override;
};

template <int Dim> void YieldCheck<Dim>::look(const AcceptedStep<Dim>& step, FindingList& findings) {
  if (!step.workpiece || step.workpiece->user_defined() || (!step.tenth())) return;
  double worst = -1;
  int at = -1;
  const std::vector<char>& plastic = step.workpiece->state_old().plastic;
  for (int p = 0; p < static_cast<int>(plastic.size()); ++p) {
    if (!plastic[p]) continue;
    const double distance = yield_distance(*step.workpiece, p);
    if (distance <= worst) continue;
    worst = distance;
    at = p;
  }
  if (at < 0) return;
  findings.largest("yield", worst);
  Finding* finding = findings.beyond("yield", "", worst, YIELD, step.t);
  if (!finding) return;
  const Vector<Dim> x = step.point(at);
  finding->place = step.place_of(x);
  finding->text =
      sentence("stress lies outside the yield surface by ", worst, " of the yield stress", step.at(x));
}

} // namespace

BURNISH_OBSERVER(yield_check, YieldCheck)

} // namespace burnish
