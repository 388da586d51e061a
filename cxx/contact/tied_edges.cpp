#include "contact/tied_edges.hpp"
#include "contact/mean_slip.hpp"

namespace burnish {
namespace {

// Mid node and ends touch one tool.
template <int Dim> bool together(const ContactModel<Dim>& model, const ContactState<Dim>& state, int middle) {
  const ContactNode<Dim>& node = state.nodes[middle];
  if (!model.is_middle(middle) || !in_contact(node.state)) return false;
  for (const int end : model.edge_ends[middle])
    if (!in_contact(state.nodes[end].state) || state.nodes[end].tool != node.tool) return false;
  return true;
}

template <int Dim> bool is_tied(const ContactModel<Dim>& model, const ContactState<Dim>& state, int i) {
  return state.nodes[i].tied && together(model, state, i);
}

// The first end that slides, -1: none.
template <int Dim>
int sliding_end(const ContactModel<Dim>& model, const ContactState<Dim>& state, int middle) {
  for (const int end : model.edge_ends[middle])
    if (state.nodes[end].state == NodeState::SLIDING) return end;
  return -1;
}

// Friction of a law that knows both stick and slip, at nodes that supports do not guide.
template <int Dim> bool may_tie(const ContactModel<Dim>& model, const ContactState<Dim>& state, int middle) {
  const int tool = state.nodes[middle].tool;
  for (const int i : {middle, model.edge_ends[middle][0], model.edge_ends[middle][1]}) {
    const TangentialLaw<Dim>& law = model.laws[tool];
    if (!model.can_slip(i) || law.frictionless() || law.friction().sticks_always()) return false;
  }
  return true;
}

// A tie can begin between events: an end sticks, and with those that slide the mid node slides too, at T = -m g as they do.
template <int Dim>
bool begins_smoothly(const ContactModel<Dim>& model, const ContactState<Dim>& state, int middle) {
  const ContactNode<Dim>& node = state.nodes[middle];
  bool sticking_end = false;
  for (const int end : model.edge_ends[middle]) {
    const ContactNode<Dim>& at_end = state.nodes[end];
    if (sticks(at_end.state))
      sticking_end = true;
    else if (sticks(node.state) || node.slip_direction.dot(at_end.slip_direction) < 0)
      return false;
  }
  return sticking_end;
}

// The three have been on their tool since before the step.
template <int Dim>
bool held_before(const ContactModel<Dim>& model, const std::vector<ContactNode<Dim>>& before,
                 const ContactState<Dim>& state, int middle) {
  const auto held = [&](int i) {
    return in_contact(before[i].state) && before[i].tool == state.nodes[middle].tool;
  };
  return held(middle) && held(model.edge_ends[middle][0]) && held(model.edge_ends[middle][1]);
}

// Weightless vertices have friction while a mid node is tied to them; one that has lost it slides without.
template <int Dim> void share_friction(const ContactModel<Dim>& model, ContactState<Dim>& state) {
  if (model.weightless.empty()) return;
  std::vector<char> shares(state.nodes.size(), 0);
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
    if (state.nodes[i].tied)
      for (const int end : model.edge_ends[i]) shares[end] = 1;
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    ContactNode<Dim>& node = state.nodes[i];
    const bool had = node.has_ties;
    node.has_ties = shares[i] && model.is_weightless(static_cast<int>(i));
    if (had && !node.has_ties && !node.bears && in_contact(node.state))
      make_slide(node, Vector<Dim>(Vector<Dim>::Zero()));
  }
}

// Weightless vertices that had no friction and have ties now stick if one of the mid nodes does, or slide as the first does.
template <int Dim> void take_states_of_middles(const ContactModel<Dim>& model, ContactState<Dim>& state) {
  if (model.weightless.empty()) return;
  for (const bool sticking : {true, false})
    for (std::size_t i = 0; i < state.nodes.size(); ++i) {
      const ContactNode<Dim>& middle = state.nodes[i];
      if (!middle.tied || sticks(middle.state) != sticking) continue;
      for (const int end : model.edge_ends[i]) {
        ContactNode<Dim>& corner = state.nodes[end];
        if (corner.state != NodeState::SLIDING || !corner.slip_direction.isZero()) continue;
        if (sticking)
          make_stick(corner);
        else
          make_slide(corner, middle.slip_direction);
      }
    }
}

// A weightless vertex is released by its force with the shares of all mid nodes on its tool, tied or not.
template <int Dim>
void add_shares_of_all(const ContactModel<Dim>& model, const ContactState<Dim>& state,
                       const std::vector<SurfaceForce<Dim>>& own, std::vector<DecidingForce<Dim>>& deciding) {
  for (std::size_t i = 0; i < own.size() && !model.weightless.empty(); ++i) {
    const ContactNode<Dim>& node = state.nodes[i];
    if (!model.is_middle(static_cast<int>(i)) || !in_contact(node.state)) continue;
    for (const int end : model.edge_ends[i])
      if (model.is_weightless(end) && in_contact(state.nodes[end].state) &&
          state.nodes[end].tool == node.tool)
        deciding[end].normal += 0.5 * own[i].N;
  }
}

// How the slip of a sliding node turns: not that of a guided one, nor in a tangent that leaves friction out.
template <int Dim>
SlipTurn<Dim> turn_of(const ContactModel<Dim>& model, const ContactState<Dim>& state,
                      const ContactPoint<Dim>& at, int i, const DecidingForce<Dim>& deciding,
                      FrictionTangent tangent) {
  if (Dim == 2 || tangent != FrictionTangent::CONSISTENT || model.is_constrained(i)) return {};
  const ContactNode<Dim>& node = state.nodes[i];
  const Surface<Dim>& surface = model.tools[node.tool]->surface();
  const SurfaceFrame<Dim> frame = surface.frame(node.place);
  const double lift = frame.n.dot(node.place.y - node.slip_origin.y);
  const Curvature<Dim> by_eta = Curvature<Dim>::Identity() - lift * frame.B;
  const TangentialLaw<Dim>& law = model.law(i, node);
  const MeanSlip<Dim> mean = mean_slip_of(model, node, at.surface.size, state.fixed);
  return law.turn(deciding, at.m, mean.way, mean.by_slip * by_eta,
                  law.slip_stiffness(deciding, mean.way, state));
}

} // namespace

template <int Dim>
void tie_edges(const ContactModel<Dim>& model, const std::vector<ContactNode<Dim>>& before,
               ContactState<Dim>& state) {
  for (int i = 0; i < static_cast<int>(state.nodes.size()); ++i) {
    ContactNode<Dim>& node = state.nodes[i];
    const bool was_tied = node.tied;
    node.tied = false;
    if (!together(model, state, i) || !may_tie(model, state, i)) continue;
    if (Dim == 3) {
      node.tied = held_before(model, before, state, i);
      continue;
    }
    const auto& [a, b] = model.edge_ends[i];
    node.tied = sticks(state.nodes[a].state) || sticks(state.nodes[b].state);
    if (!node.tied && was_tied && sticks(node.state)) make_slide(node, state.nodes[a].slip_direction);
  }
  share_friction(model, state);
  take_states_of_middles(model, state);
}

template <int Dim> void keep_ties(const ContactModel<Dim>& model, ContactState<Dim>& state) {
  for (int i = 0; i < static_cast<int>(state.nodes.size()); ++i) {
    ContactNode<Dim>& node = state.nodes[i];
    const bool possible = together(model, state, i) && may_tie(model, state, i);
    node.tied = possible && (node.tied || begins_smoothly(model, state, i));
  }
}

template <int Dim> void follow_ends(const ContactModel<Dim>& model, ContactState<Dim>& state) {
  for (int i = 0; i < static_cast<int>(state.nodes.size()); ++i)
    state.nodes[i].tied = is_tied(model, state, i);
  share_friction(model, state);
  for (int i = 0; i < static_cast<int>(state.nodes.size()); ++i) {
    ContactNode<Dim>& node = state.nodes[i];
    if (!node.tied) continue;
    const int slides = sliding_end(model, state, i);
    if (slides < 0) {
      make_stick(node);
      continue;
    }
    make_slide(node, state.nodes[slides].slip_direction);
    node.place = tied_place(model, state, i);
  }
}

template <int Dim>
std::vector<DecidingForce<Dim>>
deciding_forces(const ContactModel<Dim>& model, const ContactState<Dim>& state,
                const std::vector<Pose<Dim>>& poses, const std::vector<SurfaceForce<Dim>>& own) {
  std::vector<DecidingForce<Dim>> result(own.size());
  for (std::size_t i = 0; i < own.size(); ++i)
    if (in_contact(state.nodes[i].state)) result[i] = {own[i], state.nodes[i].tributary_area, own[i].N};
  add_shares_of_all(model, state, own, result);
  for (int i = 0; i < static_cast<int>(own.size()); ++i) {
    if (!is_tied(model, state, i)) continue;
    for (const int end : model.edge_ends[i]) {
      result[end].force.N += 0.5 * own[i].N;
      result[end].force.T += 0.5 * (tied_end(model, state, poses, i, end).follows.transpose() * own[i].T);
      result[end].area += 0.5 * state.nodes[i].tributary_area;
    }
  }
  for (std::size_t i = 0; i < own.size(); ++i)
    result[i].unpressed = state.nodes[i].has_ties && !(result[i].force.N > 0);
  return result;
}

template <int Dim>
std::vector<DecidingForce<Dim>>
deciding_forces(const ContactModel<Dim>& model, const ContactState<Dim>& state,
                const std::vector<Pose<Dim>>& poses, const Eigen::VectorXd& R) {
  std::vector<SurfaceForce<Dim>> own(state.nodes.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    const ContactNode<Dim>& node = state.nodes[i];
    if (!in_contact(node.state)) continue;
    const SurfacePoint<Dim> p = model.tools[node.tool]->point(poses[node.tool], node.place);
    const Vector<Dim> force = R.template segment<Dim>(Eigen::Index{Dim} * model.candidates[i]);
    own[i] = nodal_force(model, static_cast<int>(i), p, force).part;
  }
  return deciding_forces(model, state, poses, own);
}

template <int Dim>
NodeCones<Dim> cones_of(const ContactModel<Dim>& model, const ContactState<Dim>& state,
                        const std::vector<Pose<Dim>>& poses, const std::vector<DecidingForce<Dim>>& deciding,
                        int candidate, FrictionTangent tangent) {
  const auto end_of = [&](int i) {
    const ContactPoint<Dim> at = contact_point(model, poses, state.nodes[i]);
    const ConeTangent cone = model.law(i, state.nodes[i]).cone(deciding[i]);
    return typename NodeCones<Dim>::End{i,
                                        at.m,
                                        seen_by(tangent, cone, deciding[i].force.N),
                                        turn_of(model, state, at, i, deciding[i], tangent),
                                        {}};
  };
  NodeCones<Dim> cones;
  cones.tied = is_tied(model, state, candidate);
  if (!cones.tied) {
    if (state.nodes[candidate].state != NodeState::SLIDING) return cones;
    const auto own = end_of(candidate);
    cones.own = own.cone;
    cones.turn = own.turn;
    return cones;
  }
  cones.foot_slope = foot_slope(model, state, candidate);
  for (const int end : model.edge_ends[candidate]) {
    if (state.nodes[end].state != NodeState::SLIDING) continue;
    cones.ends.push_back(end_of(end));
    cones.ends.back().motion = tied_end(model, state, poses, candidate, end);
  }
  return cones;
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template void tie_edges<Dim>(const ContactModel<Dim>&, const std::vector<ContactNode<Dim>>&,               \
                               ContactState<Dim>&);                                                          \
  template void keep_ties<Dim>(const ContactModel<Dim>&, ContactState<Dim>&);                                \
  template void follow_ends<Dim>(const ContactModel<Dim>&, ContactState<Dim>&);                              \
  template std::vector<DecidingForce<Dim>> deciding_forces<Dim>(                                             \
      const ContactModel<Dim>&, const ContactState<Dim>&, const std::vector<Pose<Dim>>&,                     \
      const std::vector<SurfaceForce<Dim>>&);                                                                \
  template std::vector<DecidingForce<Dim>> deciding_forces<Dim>(                                             \
      const ContactModel<Dim>&, const ContactState<Dim>&, const std::vector<Pose<Dim>>&,                     \
      const Eigen::VectorXd&);                                                                               \
  template NodeCones<Dim> cones_of<Dim>(const ContactModel<Dim>&, const ContactState<Dim>&,                  \
                                        const std::vector<Pose<Dim>>&,                                       \
                                        const std::vector<DecidingForce<Dim>>&, int, FrictionTangent);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish
