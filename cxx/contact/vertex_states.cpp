#include "contact/vertex_states.hpp"
#include "contact/active_set.hpp"

namespace burnish {
namespace {

// Per candidate: half of the normal forces of the mid nodes beside it on the tool that it is near to [force].
template <int Dim>
std::vector<double> shares_of_middles(const ContactModel<Dim>& model, const ContactState<Dim>& state,
                                      const std::vector<DecidingForce<Dim>>& deciding) {
  std::vector<double> shares(deciding.size(), 0);
  for (std::size_t i = 0; i < deciding.size(); ++i) {
    if (!model.is_middle(static_cast<int>(i)) || !in_contact(state.nodes[i].state)) continue;
    for (const int end : model.edge_ends[i])
      if (state.nodes[end].tool == state.nodes[i].tool) shares[end] += 0.5 * deciding[i].force.N;
  }
  return shares;
}

// Vertices that have changed and might as well have not go back: one that holds and is pulled, one that is free and would be closed by
// less than its share of the force. Returns whether any does.
template <int Dim> bool go_back(const WindowProblem<Dim>& problem, ContactState<Dim>& state) {
  const ContactModel<Dim>& model = *problem.model;
  const auto poses = model.poses(state.q);
  const std::vector<DecidingForce<Dim>> deciding = deciding_forces(model, state, poses, *problem.R);
  const std::vector<double> shares = shares_of_middles(model, state, deciding);
  const NodeTest<Dim> test(model, poses, problem.tolerances, *problem.entry);
  bool any = false;
  for (std::size_t w = 0; w < problem.window->size(); ++w) {
    const int i = (*problem.window)[w];
    const ContactNode<Dim>& before = problem.entry->nodes[i];
    ContactNode<Dim>& node = state.nodes[i];
    const bool holds = in_contact(node.state);
    if (!model.is_weightless(i) || node.bears || holds == in_contact(before.state)) continue;
    if (holds) {
      if (!(deciding[i].force.N < 0)) continue;
      make_free(node);
      any = true;
      continue;
    }
    const Vector<Dim> x = problem.body->position(*problem.u, model.candidates[i]);
    const auto nearest = nearest_tool(model, poses, x, before, i);
    if (nearest.tool < 0 || nearest.tool != before.tool) continue;
    const Vector<Dim> n = model.tools[nearest.tool]->point(poses[nearest.tool], nearest.foot.place).n;
    const auto at = Eigen::Index{Dim} * static_cast<Eigen::Index>(w);
    const double own = n.dot(problem.flexibility->matrix().template block<Dim, Dim>(at, at) * n);
    if (nearest.foot.gap < shares[i] * own) any = test.touch(i, nearest, node) || any;
  }
  return any;
}

} // namespace

template <int Dim> bool return_vertices(const WindowProblem<Dim>& problem, ContactState<Dim>& state) {
  const ContactModel<Dim>& model = *problem.model;
  if (model.weightless.empty()) return false;
  ContactState<Dim> back = state;
  if (!go_back(problem, back)) return false;
  WindowProblem<Dim> resting = problem; // so that the passes are those of a motion, whatever drives
  PrescribedValues places = *problem.prescribed;
  places.is_motion.assign(places.is_motion.size(), 1);
  places.value = state.q;
  EntryPlaces<Dim> entry = *problem.entry;
  resting.prescribed = &places;
  resting.entry = &entry;
  resting.start = &back;
  const WindowSolution<Dim> solution = solve_window(resting);
  if (solution.singular || solution.unstable || solution.left > 0) return false;
  bool any = false;
  for (std::size_t i = 0; i < back.nodes.size(); ++i) {
    const bool holds = in_contact(solution.state.nodes[i].state);
    if (!model.is_weightless(static_cast<int>(i)) || holds == in_contact(state.nodes[i].state) ||
        holds != in_contact(back.nodes[i].state))
      continue;
    state.nodes[i] = back.nodes[i];
    any = true;
  }
  return any;
}

template bool return_vertices<2>(const WindowProblem<2>&, ContactState<2>&);
template bool return_vertices<3>(const WindowProblem<3>&, ContactState<3>&);

} // namespace burnish
