// A force on a coordinate that no node in contact moves with: the moment on a ball about the only node that it touches.
#include "diagnosis/observers.hpp"
#include "diagnosis/step/leaps.hpp"

namespace burnish {
namespace {

constexpr double UNSEEN = 1e-9; // motion of a node over the largest of the tool's points

template <int Dim> class UnseenForce final : public ObserverOf<UnseenForce<Dim>, Dim> {
public:
  void explain(const FailedStep<Dim>& step, std::vector<Failure>& causes) const override {
    const ContactModel<Dim>& model = step.setup.model();
    const auto poses = model.poses(step.state.q);
    for (int k = 0; k < static_cast<int>(step.prescribed.value.size()); ++k) {
      if (step.prescribed.is_motion[k] || step.prescribed.value[k] == 0 || model.coupling_of(k) ||
          step.prescribed.is_held(k))
        continue;
      if (!unseen(step, poses, k)) continue;
      Failure failure(Cause::UNRESISTED);
      failure.coordinate = k;
      failure.flag = true;
      causes.push_back(failure);
      return;
    }
  }

private:
  // Whether its tool touches nodes, and none of them moves with the coordinate.
  static bool unseen(const FailedStep<Dim>& step, const std::vector<Pose<Dim>>& poses, int k) {
    const ContactModel<Dim>& model = step.setup.model();
    const double least = UNSEEN * lever(model, poses, k);
    bool any = false;
    for (const auto& node : step.state.nodes) {
      if (!in_contact(node.state) || node.tool != model.tool_of(k)) continue;
      const auto p = model.tools[node.tool]->point(poses[node.tool], node.place);
      any = true;
      if (p.x_q.col(k - model.first[node.tool]).norm() > least) return false;
    }
    return any;
  }
};

} // namespace

BURNISH_OBSERVER(unseen_force, UnseenForce)

} // namespace burnish
