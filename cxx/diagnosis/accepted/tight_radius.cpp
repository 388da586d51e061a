// Tools curved tighter than the spacing of the candidates.
#include "base/sentence.hpp"
#include "diagnosis/observers.hpp"

namespace burnish {
namespace {

template <int Dim> class TightRadius final : public ObserverOf<TightRadius<Dim>, Dim> {
public:
  void begin(const AcceptedStep<Dim>& step, FindingList& findings) override {
    const double h = step.body().spacing;
    for (std::size_t t = 0; t < step.model().tools.size(); ++t) {
      const auto& tool = step.model().tools[t];
      const double radius = step.poses[t].size * tool->surface().tightest_radius();
      if (!(radius < h)) continue;
      Finding* finding = findings.report("contact", "curvature " + tool->name(), Severity::WARNING, 0);
      if (finding)
        finding->text = sentence("the tightest radius of tool \"", tool->name(), "\", ", radius,
                                 ", is smaller than the distance of the contact nodes, ", h,
                                 ": the mesh cannot follow it there, refine the contact surface");
    }
  }
};

} // namespace

BURNISH_OBSERVER(tight_radius, TightRadius)

} // namespace burnish
