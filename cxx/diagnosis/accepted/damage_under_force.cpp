// Damage while a tool is under force: softening, without a limit in mesh and steps (ALGORITHMS.md 16.8).
#include "base/sentence.hpp"
#include "diagnosis/observers.hpp"
#include <algorithm>

namespace burnish {
namespace {

template <int Dim> class DamageUnderForce final : public ObserverOf<DamageUnderForce<Dim>, Dim> {
public:
  void look(const AcceptedStep<Dim>& step, FindingList& findings) override {
    if (!step.workpiece || !step.prescribed) return;
    const auto& rate = step.workpiece->state_old().integrity_rate;
    const auto damaged = std::count_if(rate.begin(), rate.end(), [](double r) { return r < 0; });
    if (damaged == 0) return;
    for (int k = 0; k < static_cast<int>(step.contact.q.size()); ++k) {
      if (step.prescribed->is_motion[k] || step.generalized_force[k] == 0) continue;
      Finding* finding =
          findings.report("damage", "", Severity::WARNING, static_cast<double>(damaged), step.t);
      if (finding)
        finding->text =
            sentence(damaged, " points are damaged at t = ", step.t, " while ", step.model().coordinate(k),
                     " is under force: damage is softening, and the result depends on the mesh and, since "
                     "steps= of damage counts steps, on their length; prescribe the motion, and compare "
                     "dtmax= halved");
      return;
    }
  }
};

} // namespace

BURNISH_OBSERVER(damage_under_force, DamageUnderForce)

} // namespace burnish
