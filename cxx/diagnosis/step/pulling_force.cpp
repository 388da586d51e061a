// A force that draws its tool away from all nodes that it touches.
#include "diagnosis/observers.hpp"

namespace burnish {
namespace {

constexpr double ALONG = 0.5; // part of a node's motion by the coordinate that is normal to the tool

template <int Dim> class PullingForce final : public ObserverOf<PullingForce<Dim>, Dim> {
public:
  void explain(const FailedStep<Dim>& step, std::vector<Failure>& causes) const override {
    const ContactModel<Dim>& model = step.setup.model();
    const PrescribedValues& prescribed = step.prescribed;
    const auto poses = model.poses(step.state.q);
    for (int k = 0; k < static_cast<int>(prescribed.value.size()); ++k) {
      if (prescribed.is_motion[k] || prescribed.value[k] == 0 || model.coupling_of(k) ||
          prescribed.is_held(k))
        continue;
      bool any = false, all = true;
      for (const auto& node : step.state.nodes) {
        if (!in_contact(node.state) || node.tool != model.tool_of(k)) continue;
        const auto p = model.tools[node.tool]->point(poses[node.tool], node.place);
        const Vector<Dim> motion = p.x_q.col(k - model.first[node.tool]);
        any = true;
        all = all && motion.dot(p.n) * (prescribed.value[k] > 0 ? 1 : -1) < -ALONG * motion.norm();
      }
      if (!any || !all) continue;
      Failure failure(Cause::PULLING);
      failure.coordinate = k;
      failure.value = prescribed.value[k];
      causes.push_back(failure);
      return;
    }
  }
};

} // namespace

BURNISH_OBSERVER(pulling_force, PullingForce)

} // namespace burnish
