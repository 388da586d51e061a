#include "diagnosis/step/unheld_workpiece.hpp"
#include "base/decompositions.hpp"
#include "contact/rigid_modes.hpp"
#include "diagnosis/observers.hpp"
#include <algorithm>

namespace burnish {
namespace {

constexpr double UNRESISTED = 1e-6; // pivot over the largest: the motion meets no resistance
constexpr long FEW = 4;             // nodes in contact that may slip from one to the next

template <int Dim> class UnheldWorkpiece final : public ObserverOf<UnheldWorkpiece<Dim>, Dim> {
public:
  void explain(const FailedStep<Dim>& step, std::vector<Failure>& causes) const override {
    if (!step.on_hold && unheld(step.setup, step.state, step.u)) causes.push_back(Cause::UNHELD);
  }
};

// A body that a few nodes in contact hold.
template <int Dim> class FewNodesHold final : public ObserverOf<FewNodesHold<Dim>, Dim> {
public:
  void explain(const FailedStep<Dim>& step, std::vector<Failure>& causes) const override {
    const bool cycles = step.found.not_converged() || step.found.cause == Cause::NOT_HELD;
    const bool ended = !causes.empty() && causes.back().cause == Cause::END_OF_TOOL; // says it better
    if (!cycles || ended || constrains_rigid_motions(step.setup.body())) return;
    const long touching = std::count_if(step.state.nodes.begin(), step.state.nodes.end(),
                                        [](const auto& node) { return in_contact(node.state); });
    if (touching == 0 || touching > FEW) return;
    causes.push_back(Cause::HANGS);
    causes.back().count = static_cast<int>(touching);
  }
};

} // namespace

template <int Dim>
bool unheld(const ContactSetup<Dim>& setup, const ContactState<Dim>& state, const Eigen::VectorXd& u) {
  constexpr int modes = RigidModes<Dim>::count;
  if (constrains_rigid_motions(setup.body())) return false;
  const auto& body = setup.body();
  const RigidModes<Dim> motions(body, body.position(u, setup.candidates()[0]));
  Eigen::Matrix<double, modes, modes> resisted = motions.resisted_by_supports(body, u);
  const auto poses = setup.model().poses(state.q);
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    const auto& node = state.nodes[i];
    if (!in_contact(node.state)) continue;
    const auto m = motions(body.position(u, setup.candidates()[i]));
    const Vector<Dim> n = setup.model().tools[node.tool]->point(poses[node.tool], node.place).n;
    resisted +=
        sticks(node.state) ? (m.transpose() * m).eval() : (m.transpose() * n * n.transpose() * m).eval();
  }
  const Eigen::VectorXd eigenvalues = symmetric_eigen(resisted).values;
  return !(eigenvalues[0] > UNRESISTED * eigenvalues[modes - 1]);
}

template bool unheld<2>(const ContactSetup<2>&, const ContactState<2>&, const Eigen::VectorXd&);
template bool unheld<3>(const ContactSetup<3>&, const ContactState<3>&, const Eigen::VectorXd&);
BURNISH_OBSERVER(unheld_workpiece, UnheldWorkpiece)
BURNISH_OBSERVER(few_nodes_hold, FewNodesHold)

} // namespace burnish
