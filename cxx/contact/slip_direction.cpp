#include "contact/slip_direction.hpp"
#include "contact/mean_slip.hpp"
#include <algorithm>

namespace burnish {

namespace {

// Whether m follows slip and force. Where states are fixed that of a slip back does: zero slip, between both, is sticking at the limit.
// Under tension no direction agrees with the force.
template <int Dim>
bool turns(const TangentialLaw<Dim>& law, const DecidingForce<Dim>& deciding, const Param<Dim>& slip,
           const Param<Dim>& m, bool fixed) {
  return fixed ? law.capacity(deciding) > 0 : !TangentialLaw<Dim>::slips_back(slip, m, 0);
}

} // namespace

template <int Dim> double slip_stiffness(const ContactModel<Dim>& model, const NodeBlockMatrix<Dim>& K) {
  if (Dim == 2) return 0;
  std::vector<double> own;
  for (const int node : model.candidates) {
    const double* block = K.block(K.find(node, node));
    double trace = 0;
    for (int c = 0; c < Dim; ++c) trace += block[c * Dim + c];
    own.push_back(trace / Dim);
  }
  const auto middle = own.begin() + static_cast<std::ptrdiff_t>(own.size() / 2);
  std::nth_element(own.begin(), middle, own.end());
  return SLIP_STIFFNESS * std::max(*middle, 0.);
}

template <int Dim>
void begin_turn(const ContactModel<Dim>& model, const BeginningSlips<Dim>& slips, int candidate,
                NodeCones<Dim>& cones) {
  if (slips.by_friction.empty()) return;
  const auto turn_of = [&](int i, SlipTurn<Dim>& turn) {
    const ContactNode<Dim>& node = slips.state.nodes[i];
    if (node.state != NodeState::SLIDING || !slips.by_friction[node.tool] || !(slips.deciding[i].force.N > 0))
      return;
    if (!turn.H.isZero(0) || model.is_constrained(i) || model.law(i, node).frictionless()) return;
    const Param<Dim> slip = slip_of(model, node, slips.poses[node.tool].size);
    turn = TangentialLaw<Dim>::first_turn(contact_point(model, slips.poses, node).m, slip,
                                          slips.state.slip_stiffness);
  };
  if (!cones.tied) turn_of(candidate, cones.turn);
  for (auto& end : cones.ends) turn_of(end.candidate, end.turn);
}

template <int Dim>
void turn_slips(const ContactModel<Dim>& model, const Eigen::VectorXd& R, ContactState<Dim>& state) {
  if (Dim == 2) return;
  const auto poses = model.poses(state.q);
  const std::vector<DecidingForce<Dim>> deciding = deciding_forces(model, state, poses, R);
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    ContactNode<Dim>& node = state.nodes[i];
    const int candidate = static_cast<int>(i);
    if (node.state != NodeState::SLIDING || node.tied || model.law(candidate, node).frictionless()) continue;
    const ContactPoint<Dim> at = contact_point(model, poses, node);
    const double size = poses[node.tool].size;
    const Param<Dim> slip = slip_of(model, node, size);
    const double c = model.law(candidate, node).slip_stiffness(deciding[i], slip, state);
    Param<Dim> way = c * mean_slip_of(model, node, size, state.fixed).way - deciding[i].force.T;
    if (model.is_constrained(candidate)) {
      const Curvature<Dim> free = slip_space(model, candidate, at.surface);
      const Param<Dim> kept = free * at.m;
      way = kept.norm() > 0.1 ? kept
                              : Param<Dim>(free * way); // carried from a node without a direction, or across
    } else if (!(state.slip_stiffness > 0) ||
               !turns(model.law(candidate, node), deciding[i], slip, at.m, state.fixed))
      continue;
    if (!(way.norm() > 0)) continue;
    node.slip_direction = in_tool_frame(poses[node.tool], at.surface, Param<Dim>(way.normalized()));
  }
  follow_ends(model, state);
}

template <int Dim>
double direction_residual(const TangentialLaw<Dim>& law, const DecidingForce<Dim>& deciding,
                          const Param<Dim>& m, const Param<Dim>& slip, double c) {
  const double size = slip.norm(), g = deciding.unpressed ? 0 : law.capacity(deciding);
  if (Dim == 2 || !(g > 0) || !(c * size > 0) || TangentialLaw<Dim>::slips_back(slip, m, 0)) return 0;
  const double own = c / SLIP_STIFFNESS * size;
  return (m - slip / size).norm() * g * own / (g + own);
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template double slip_stiffness<Dim>(const ContactModel<Dim>&, const NodeBlockMatrix<Dim>&);                \
  template void begin_turn<Dim>(const ContactModel<Dim>&, const BeginningSlips<Dim>&, int, NodeCones<Dim>&); \
  template void turn_slips<Dim>(const ContactModel<Dim>&, const Eigen::VectorXd&, ContactState<Dim>&);       \
  template double direction_residual<Dim>(const TangentialLaw<Dim>&, const DecidingForce<Dim>&,              \
                                          const Param<Dim>&, const Param<Dim>&, double);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish
