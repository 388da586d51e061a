#include "stepping/predictor.hpp"
#include <cmath>

namespace burnish {
namespace {

// Coordinates under motion go to their target, those under force continue at their last rate.
template <int Dim>
Eigen::VectorXd predict_coordinates(const Program& program, const Eigen::VectorXd& q,
                                    const StepHistory<Dim>& history, double ratio) {
  Eigen::VectorXd result = q;
  for (Eigen::Index k = 0; k < q.size(); ++k) {
    if (program.is_motion[k])
      result[k] = program.value[k];
    else if (history.dq.size() == q.size())
      result[k] += ratio * history.dq[k];
  }
  return result;
}

// Mean of the carrier's motion in the last and in the present step, for each tool.
template <int Dim> struct Shift {
  RigidMotion<Dim> now, mean_inverse;
  Tensor<Dim> turn;
};
template <int Dim>
Shift<Dim> shift_of(const ContactModel<Dim>& model, int tool, const Eigen::VectorXd& q_older,
                    const Eigen::VectorXd& q_old, const Eigen::VectorXd& q_new) {
  const auto& coordinates = model.tools[tool]->coordinates();
  const auto last = coordinates.carrier(model.tool_q(q_older, tool), model.tool_q(q_old, tool));
  Shift<Dim> shift;
  shift.now = coordinates.carrier(model.tool_q(q_old, tool), model.tool_q(q_new, tool));
  const RigidMotion<Dim> a = shift.now.inverse(), b = last.inverse();
  shift.mean_inverse = {0.5 * (a.R + b.R), 0.5 * (a.d + b.d)};
  shift.turn = 0.5 * (shift.now.R + last.R);
  for (int c = 0; c < Dim; ++c) shift.turn.col(c).normalize();
  return shift;
}

// u + ratio * turned last increment, taken from where the point was seen from the tool one step ago.
template <int Dim>
Eigen::VectorXd
carry_increment(const ContactModel<Dim>& model, const BodyView<Dim>& body, const MeshLocator<Dim>& locator,
                const Mesh<Dim>& d, const ContactState<Dim>& state, const Eigen::VectorXd& u,
                const StepHistory<Dim>& history, const std::vector<Shift<Dim>>& shifts, double ratio) {
  Eigen::VectorXd result = u;
  const auto poses = model.poses(state.q);
  double N[16];
  for (int a = 0; a < d.num_nodes; ++a) {
    int tool = 0;
    if (shifts.size() > 1)
      tool = nearest_tool(model, poses, body.position(u, a), ContactNode<Dim>{}, -1).tool;
    const Shift<Dim>& shift = shifts[tool];
    const Vector<Dim> P = shift.mean_inverse(d.node(a));
    const int element = locator.find(P, a);
    Vector<Dim> increment = Vector<Dim>::Zero();
    if (element >= 0) {
      locator.shape(element, P, N);
      for (int b = 0; b < d.nodes_per_element; ++b)
        increment += N[b] * history.du.template segment<Dim>(Dim * d.element(element)[b]);
      increment = shift.turn * increment;
    } else {
      increment = history.du.template segment<Dim>(Dim * a);
    }
    for (int c = 0; c < Dim; ++c)
      if (!body.fixed[Dim * a + c]) result[Dim * a + c] += ratio * increment[c];
  }
  return result;
}

// Where each candidate would stick if it touched in this step: contact nodes at their place, free ones at the
// projection at the start of the step.
template <int Dim>
std::vector<ContactNode<Dim>> entry_nodes(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                                          const ContactState<Dim>& state, const Eigen::VectorXd& u) {
  std::vector<ContactNode<Dim>> entry = state.nodes;
  const auto poses = model.poses(state.q);
  for (std::size_t i = 0; i < entry.size(); ++i) {
    if (!in_contact(entry[i].state)) {
      const auto nearest =
          nearest_tool(model, poses, body.position(u, model.candidates[i]), entry[i], static_cast<int>(i));
      entry[i].tool = nearest.tool;
      entry[i].s = nearest.foot.s;
    }
    entry[i].s_ref = entry[i].s;
  }
  return entry;
}

// State of the candidate that stood where this one stands now, seen from the tool.
template <int Dim>
void carry_states(const ContactModel<Dim>& model, const BodyView<Dim>& body, const ContactState<Dim>& old,
                  const std::vector<Shift<Dim>>& shifts, ContactState<Dim>& state) {
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    ContactNode<Dim>& node = state.nodes[i];
    node.state = NodeState::FREE;
    node.slip_sign = 0;
    for (std::size_t t = 0; t < shifts.size(); ++t) {
      const Vector<Dim> X = body.X.template segment<Dim>(Dim * model.candidates[i]);
      const Vector<Dim> P = shifts[t].now.inverse()(X);
      double best = std::pow(1.5 * body.spacing, 2);
      const ContactNode<Dim>* from = nullptr;
      for (std::size_t j = 0; j < old.nodes.size(); ++j) {
        const double d2 = (body.X.template segment<Dim>(Dim * model.candidates[j]) - P).squaredNorm();
        if (d2 < best) {
          best = d2;
          from = &old.nodes[j];
        }
      }
      if (!from || !in_contact(from->state) || from->tool != static_cast<int>(t)) continue;
      const bool slides = model.law(static_cast<int>(i), static_cast<int>(t)).frictionless();
      node.state = slides ? NodeState::SLIDING : from->state;
      node.slip_sign = slides ? 0 : from->slip_sign;
      if (node.tool != static_cast<int>(t)) node.s = node.s_ref = from->s;
      node.tool = static_cast<int>(t);
      break;
    }
  }
}

// Contact nodes onto their tools at the predicted coordinates.
template <int Dim>
void place_contact_nodes(const ContactModel<Dim>& model, const BodyView<Dim>& body, bool may_stick,
                         ContactState<Dim>& state, Eigen::VectorXd& u) {
  const auto poses = model.poses(state.q);
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    ContactNode<Dim>& node = state.nodes[i];
    if (!in_contact(node.state)) continue;
    const auto& tool = *model.tools[node.tool];
    const int a = model.candidates[i];
    const Vector<Dim> x = body.position(u, a);
    if (node.state == NodeState::SLIDING) {
      node.s = tool.closest_point(poses[node.tool], x, node.s_ref).s;
      const bool against = (node.s - node.s_ref)[0] * node.slip_sign < 0;
      if (may_stick && against && !model.law(static_cast<int>(i), node.tool).frictionless())
        node.state = NodeState::STICKING;
    }
    if (holds(node.state)) {
      node.s = node.s_ref;
      node.slip_sign = 0;
    }
    u.template segment<Dim>(Dim * a) +=
        offset_to(model, static_cast<int>(i), tool.surface(poses[node.tool], node.s), x);
  }
}

} // namespace

template <int Dim>
Prediction<Dim> predict(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                        const MeshLocator<Dim>& locator, const Mesh<Dim>& mesh, const Program& program,
                        const ContactState<Dim>& state, const Eigen::VectorXd& u,
                        const StepHistory<Dim>& history, double dt, bool carry) {
  Prediction<Dim> result;
  const bool known = history.dt > 0 && history.du.size() == u.size();
  const double ratio = known ? dt / history.dt : 0;
  result.u = u;
  result.entry = entry_nodes(model, body, state, u);
  result.state.nodes = result.entry;
  result.state.q = predict_coordinates(program, state.q, history, ratio);
  for (auto& node : result.state.nodes)
    if (node.state == NodeState::TOUCHED) node.state = NodeState::STICKING;
  if (known && carry) {
    std::vector<Shift<Dim>> shifts;
    for (std::size_t t = 0; t < model.tools.size(); ++t)
      shifts.push_back(shift_of(model, static_cast<int>(t), history.q_old, state.q, result.state.q));
    result.u = carry_increment(model, body, locator, mesh, state, u, history, shifts, ratio);
    carry_states(model, body, state, shifts, result.state);
  } else if (known) {
    for (Eigen::Index d = 0; d < u.size(); ++d)
      if (!body.fixed[d]) result.u[d] += ratio * history.du[d];
  }
  // Without a step before, the nodes stay where they are: the first iteration brings them to the tool by an
  // offset.
  if (known) place_contact_nodes(model, body, carry, result.state, result.u);
  return result;
}

template Prediction<2> predict<2>(const ContactModel<2>&, const BodyView<2>&, const MeshLocator<2>&,
                                  const Mesh<2>&, const Program&, const ContactState<2>&,
                                  const Eigen::VectorXd&, const StepHistory<2>&, double, bool);

} // namespace burnish
