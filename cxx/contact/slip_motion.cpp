#include "contact/slip_motion.hpp"
#include "contact/coupling.hpp"
#include "contact/mean_slip.hpp"
#include "contact/tied_edges.hpp"
#include <algorithm>

namespace burnish {

template <int Dim>
void measure_slips(const ContactModel<Dim>& model, double dt, const Eigen::VectorXd& R,
                   ContactState<Dim>& state) {
  const auto poses = model.poses(state.q);
  const std::vector<DecidingForce<Dim>> deciding = deciding_forces(model, state, poses, R);
  // with ties two ways to one state are some 1e-4 apart (ALGORITHMS.md 4), and with memories more
  const bool ties = std::any_of(state.nodes.begin(), state.nodes.end(),
                                [](const auto& node) { return node.tied || node.has_ties; });
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    ContactNode<Dim>& node = state.nodes[i];
    node.slip_rate = 0;
    node.slip_memory.setZero();
    if (node.state != NodeState::SLIDING) continue;
    const ContactPoint<Dim> at = contact_point(model, poses, node);
    const Param<Dim> slip = slip_of(model, node, at.surface.size);
    node.slip_rate = TangentialLaw<Dim>::advance(slip, at.m) / dt;
    node.slip_direction = in_tool_frame(poses[node.tool], at.surface, at.m);
    if (ties) continue;
    const double g = model.law(static_cast<int>(i), node).capacity(deciding[i]);
    node.slip_memory = slip_memory(slip.norm(), g, state.slip_stiffness) * node.slip_direction;
  }
}

template <int Dim>
void move_by(const ContactModel<Dim>& model, const typename Condensation<Dim>::Expansion& increment,
             ContactState<Dim>& state) {
  const auto poses = model.poses(state.q);
  state.q += increment.dq;
  follow(model, state.q);
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    ContactNode<Dim>& node = state.nodes[i];
    if (node.state != NodeState::SLIDING || node.tied) continue;
    const Param<Dim> slip = increment.slip.col(static_cast<Eigen::Index>(i));
    node.place = model.tools[node.tool]->surface().moved(node.place, slip / poses[node.tool].size);
  }
  follow_ends(model, state);
}

template <int Dim>
void shorten(const ContactModel<Dim>& model, const ContactState<Dim>& start, double fraction,
             ContactState<Dim>& end) {
  end.q = (start.q + fraction * (end.q - start.q)).eval();
  follow(model, end.q);
  for (std::size_t i = 0; i < end.nodes.size(); ++i) {
    ContactNode<Dim>& node = end.nodes[i];
    if (node.state == NodeState::SLIDING)
      node.place = model.tools[node.tool]->surface().between(start.nodes[i].place, node.place, fraction);
  }
}

template <int Dim>
double contact_speed(const ContactModel<Dim>& model, const ContactState<Dim>& state,
                     const Eigen::VectorXd& q_old, double dt) {
  double speed = 0;
  const auto poses = model.poses(state.q);
  for (int t = 0; t < static_cast<int>(model.tools.size()); ++t) {
    const auto& coordinates = model.tools[t]->coordinates();
    const auto back = coordinates.carrier(model.tool_q(q_old, t), model.tool_q(state.q, t)).inverse();
    for (const auto& node : state.nodes) {
      if (!in_contact(node.state) || node.tool != t) continue;
      const auto p = model.tools[t]->point(poses[t], node.place);
      speed = std::max(speed, (p.E.transpose() * (p.x - back(p.x))).norm() / dt);
    }
  }
  return speed;
}

ContactWay contact_way(const ContactModel<3>& model, const ContactState<3>& state,
                       const Eigen::VectorXd& q_old, int tool) {
  ContactWay way;
  const auto pose = model.tools[tool]->coordinates().pose(model.tool_q(state.q, tool));
  const auto back = model.tools[tool]
                        ->coordinates()
                        .carrier(model.tool_q(q_old, tool), model.tool_q(state.q, tool))
                        .inverse();
  for (const auto& node : state.nodes) {
    if (!in_contact(node.state) || node.tool != tool) continue;
    const auto p = model.tools[tool]->point(pose, node.place);
    const Vector<3> moved = p.E * (p.E.transpose() * (p.x - back(p.x)));
    way.sum += moved;
    way.length += moved.norm();
  }
  return way;
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template void measure_slips<Dim>(const ContactModel<Dim>&, double, const Eigen::VectorXd&,                 \
                                   ContactState<Dim>&);                                                      \
  template void move_by<Dim>(const ContactModel<Dim>&, const Condensation<Dim>::Expansion&,                  \
                             ContactState<Dim>&);                                                            \
  template void shorten<Dim>(const ContactModel<Dim>&, const ContactState<Dim>&, double,                     \
                             ContactState<Dim>&);                                                            \
  template double contact_speed<Dim>(const ContactModel<Dim>&, const ContactState<Dim>&,                     \
                                     const Eigen::VectorXd&, double);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish
