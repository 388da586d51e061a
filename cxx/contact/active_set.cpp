#include "contact/active_set.hpp"
#include "contact/coupling.hpp"
#include "contact/tool_support.hpp"
#include <cmath>

namespace burnish {
namespace {

// The window's nodes that the block is made of: in contact, or with added stiffness.
template <int Dim>
std::vector<int> active_positions(const ContactState<Dim>& state, const WindowProblem<Dim>& problem) {
  const std::vector<int>& window = *problem.window;
  const Eigen::VectorXd& added = problem.added_stiffness;
  std::vector<int> active;
  for (std::size_t w = 0; w < window.size(); ++w)
    if (in_contact(state.nodes[window[w]].state) ||
        (added.size() > 0 && (added.template segment<Dim>(Dim * w).array() != 0).any()))
      active.push_back(static_cast<int>(w));
  return active;
}

// Their free components, as places in the block and in the window.
struct FreeComponents {
  std::vector<int> in_block, in_window;
};
template <int Dim>
FreeComponents free_components(const ContactModel<Dim>& model, const std::vector<int>& window,
                               const std::vector<int>& active) {
  FreeComponents free;
  for (std::size_t a = 0; a < active.size(); ++a)
    for (int c = 0; c < Dim; ++c) {
      if (!model.constrained.empty() && model.constrained[window[active[a]]][c]) continue;
      free.in_block.push_back(Dim * static_cast<int>(a) + c);
      free.in_window.push_back(Dim * active[a] + c);
    }
  return free;
}

template <int Dim> Eigen::VectorXd of_nodes(const Eigen::VectorXd& window, const std::vector<int>& active) {
  Eigen::VectorXd part(Dim * static_cast<Eigen::Index>(active.size()));
  for (std::size_t a = 0; a < active.size(); ++a)
    part.template segment<Dim>(Dim * a) = window.template segment<Dim>(Dim * active[a]);
  return part;
}

// Deciding forces of the window's active nodes under the forces on them.
template <int Dim, class Force>
std::vector<DecidingForce<Dim>> deciding_at(const ContactModel<Dim>& model, const ContactState<Dim>& state,
                                            const std::vector<Pose<Dim>>& poses,
                                            const std::vector<int>& window, const std::vector<int>& active,
                                            const Force& force) {
  std::vector<SurfaceForce<Dim>> own(state.nodes.size());
  for (const int w : active) {
    const ContactNode<Dim>& node = state.nodes[window[w]];
    if (!in_contact(node.state)) continue;
    const auto p = model.tools[node.tool]->point(poses[node.tool], node.place);
    own[window[w]] = nodal_force(model, window[w], p, force(window[w])).part;
  }
  return deciding_forces(model, state, own);
}

// Linearizations of the active nodes at the start of the iteration, in the states of the trial.
template <int Dim>
std::vector<NodeLinearization<Dim>> linearize(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                                              const ContactState<Dim>& start, const ContactState<Dim>& trial,
                                              const WindowProblem<Dim>& problem,
                                              const std::vector<int>& active, Eigen::VectorXd& offset) {
  const auto poses = model.poses(start.q);
  const auto force = [&](int candidate) { // a node that touches now carried no force yet
    if (!in_contact(start.nodes[candidate].state)) return Vector<Dim>(Vector<Dim>::Zero());
    return Vector<Dim>(problem.R->template segment<Dim>(Dim * model.candidates[candidate]));
  };
  const std::vector<DecidingForce<Dim>> deciding =
      deciding_at(model, trial, poses, *problem.window, active, force);
  std::vector<NodeLinearization<Dim>> nodes;
  offset = Eigen::VectorXd::Zero(Dim * static_cast<Eigen::Index>(active.size()));
  for (std::size_t a = 0; a < active.size(); ++a) {
    const int candidate = (*problem.window)[active[a]], mesh_node = model.candidates[candidate];
    nodes.emplace_back();
    nodes.back().in_contact = in_contact(trial.nodes[candidate].state);
    if (!nodes.back().in_contact) continue;
    const NodeCones<Dim> cones = cones_of(model, trial, poses, deciding, candidate, problem.friction_tangent);
    nodes.back() = linearize_node(model, trial.nodes[candidate], candidate, poses, force(candidate),
                                  problem.terms, &cones);
    if (!model.couplings.empty()) eliminate_followers(model, start.q, problem.terms, nodes.back());
    offset.template segment<Dim>(Dim * a) =
        offset_to(model, candidate, nodes.back().point, body.position(*problem.u, mesh_node));
  }
  return nodes;
}

// Dense block of the active nodes at fixed states; F on the window and the states moved by slips and dq.
template <int Dim>
bool solve_active(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                  const PrescribedValues& prescribed, const ContactState<Dim>& start,
                  const ContactState<Dim>& trial, const WindowProblem<Dim>& problem,
                  WindowSolution<Dim>& out) {
  const std::vector<int>& window = *problem.window;
  const std::vector<int> active = active_positions(trial, problem);
  const FreeComponents free = free_components(model, window, active);
  out.weakest_coordinate = -1;
  out.singular = !problem.flexibility->select(free.in_window);
  if (out.singular) return false;
  ContactBlockInput<Dim> input;
  const auto nodes = linearize(model, body, start, trial, problem, active, input.offset);
  input.nodes = &nodes;
  input.free = &free.in_block;
  input.flexibility = problem.flexibility;
  input.free_increment = of_nodes<Dim>(problem.free_increment, active);
  if (problem.added_stiffness.size() > 0)
    input.added_stiffness = of_nodes<Dim>(problem.added_stiffness, active);
  input.test_stability = problem.test_stability;
  input.symmetric_part = problem.friction_tangent == FrictionTangent::SYMMETRIC;
  const auto block = solve_contact_block(model, prescribed, start.q, input);
  out.unstable = block.unstable;
  out.singular = block.singular;
  out.weakest_coordinate = block.weakest_coordinate;
  if (block.singular) return false;
  out.state = trial;
  out.state.q = start.q + block.dq;
  follow(model, out.state.q);
  out.F = out.load = Eigen::VectorXd::Zero(Dim * static_cast<Eigen::Index>(window.size()));
  for (std::size_t a = 0; a < active.size(); ++a) {
    ContactNode<Dim>& node = out.state.nodes[window[active[a]]];
    if (nodes[a].sliding)
      node.place =
          model.tools[node.tool]->surface().moved(node.place, block.slip.col(static_cast<Eigen::Index>(a)));
    out.F.template segment<Dim>(Dim * active[a]) = block.F.template segment<Dim>(Dim * a);
    out.load.template segment<Dim>(Dim * active[a]) = block.load.template segment<Dim>(Dim * a);
  }
  follow_ends(model, out.state);
  return true;
}

// A node in contact.
template <int Dim>
bool test_contact(const ContactModel<Dim>& model, int candidate, const std::vector<Pose<Dim>>& poses,
                  const ContactNode<Dim>& solved, const Vector<Dim>& F, const DecidingForce<Dim>& deciding,
                  const ActiveSetOptions& options, ContactNode<Dim>& node) {
  const TangentialLaw<Dim>& law = model.law(candidate, node.tool);
  const ContactPoint<Dim> at = contact_point(model, poses, solved);
  const double N = nodal_force(model, candidate, at.surface, F).part.N;
  const ContactTolerance tolerance = options.tolerance_of(node.tool);
  if (node.tied) {
    if (N < -tolerance.force) make_free(node);
    return !in_contact(node.state);
  }
  const SurfaceForce<Dim>& force = deciding.force;
  switch (law.test(node.state, N, force, slip_of(model, solved), at.m, deciding.area, tolerance)) {
  case Change::NONE:
    return false;
  case Change::RELEASE:
    make_free(node);
    return true;
  case Change::STICK:
    make_stick(node);
    return true;
  case Change::SLIDE: // friction opposes slip: the tangential force tells its direction
    make_slide(node, in_tool_frame(poses[node.tool], at.surface, law.slip_against(force.T)));
    return true;
  }
  return false;
}

// A free node that would penetrate comes into contact where it would have touched; one that always sticks and could not
// stay there (released twice in this step) where it is now.
template <int Dim>
bool test_free(const ContactModel<Dim>& model, int candidate, const std::vector<Pose<Dim>>& poses,
               const Vector<Dim>& x, const EntryPlaces<Dim>& entry, double gap_tolerance,
               ContactNode<Dim>& node) {
  const ContactNode<Dim>& enters = entry.nodes[candidate];
  const auto nearest = nearest_tool(model, poses, x, enters, candidate);
  if (!(nearest.foot.gap < -gap_tolerance)) return false;
  const auto foot = model.tools[nearest.tool]->point(poses[nearest.tool], nearest.foot.place);
  if (admissible_normal(model, candidate, foot.n).isZero()) return false; // the supports block it
  const TangentialLaw<Dim>& law = model.law(candidate, nearest.tool);
  const bool returns =
      enters.tool == nearest.tool && !(entry.releases[candidate] > 1 && law.friction().sticks_always());
  node.tool = nearest.tool;
  node.slip_origin = returns ? enters.slip_origin : nearest.foot.place;
  node.place = law.frictionless() ? nearest.foot.place : node.slip_origin;
  node.state = law.frictionless() ? NodeState::SLIDING : NodeState::STICKING;
  node.slip_direction.setZero();
  return true;
}

// One pass of tests over the window; returns the number of changes.
template <int Dim>
int test_window(const ContactModel<Dim>& model, const BodyView<Dim>& body, const WindowProblem<Dim>& problem,
                const WindowSolution<Dim>& solution, ContactState<Dim>& trial) {
  const std::vector<int>& window = *problem.window;
  const auto poses = model.poses(solution.state.q);
  const Eigen::VectorXd du = problem.free_increment + problem.flexibility->matrix() * solution.load;
  std::vector<int> all(window.size()), place(solution.state.nodes.size(), -1);
  for (std::size_t w = 0; w < window.size(); ++w) place[window[w]] = all[w] = static_cast<int>(w);
  const std::vector<DecidingForce<Dim>> deciding =
      deciding_at(model, solution.state, poses, window, all, [&](int i) {
        return Vector<Dim>(solution.F.template segment<Dim>(Eigen::Index{Dim} * place[i]));
      });
  int changes = 0;
  for (std::size_t w = 0; w < window.size(); ++w) {
    const int i = window[w];
    const Vector<Dim> x = body.position(*problem.u, model.candidates[i]) + du.template segment<Dim>(Dim * w);
    const Vector<Dim> F = solution.F.template segment<Dim>(Dim * w);
    changes += test_node(model, i, poses, solution.state.nodes[i], F, deciding[i], x, *problem.entry,
                         problem.options, trial.nodes[i]);
  }
  return changes;
}

} // namespace

template <int Dim>
bool test_node(const ContactModel<Dim>& model, int candidate, const std::vector<Pose<Dim>>& poses,
               const ContactNode<Dim>& solved, const Vector<Dim>& F, const DecidingForce<Dim>& deciding,
               const Vector<Dim>& x, EntryPlaces<Dim>& entry, const ActiveSetOptions& options,
               ContactNode<Dim>& node) {
  if (!in_contact(node.state)) return test_free(model, candidate, poses, x, entry, options.gap, node);
  const bool changed = test_contact(model, candidate, poses, solved, F, deciding, options, node);
  if (!in_contact(node.state)) ++entry.releases[candidate];
  return changed;
}

template <int Dim>
WindowSolution<Dim> solve_window(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                                 const PrescribedValues& prescribed, const ContactState<Dim>& state,
                                 const WindowProblem<Dim>& problem) {
  WindowSolution<Dim> solution;
  ContactState<Dim> trial = state;
  std::vector<char> refused(state.nodes.size(), 0); // nodes that could not stick
  int trials = 0;
  for (solution.passes = 1;; ++solution.passes) {
    if (problem.adapt) stick_unsupported(model, prescribed, trial, refused);
    if (problem.adapt && problem.added_stiffness.size() > 0 && trials < problem.options.max_neutral_trials)
      trials += stick_at_neutral_point(model, trial, refused);
    follow_ends(model, trial);
    if (!solve_active(model, body, prescribed, state, trial, problem, solution)) break;
    if (!problem.adapt || solution.passes >= problem.options.max_passes) break;
    const ContactState<Dim> before = trial;
    if (test_window(model, body, problem, solution, trial) == 0) break;
    for (std::size_t i = 0; i < refused.size(); ++i)
      refused[i] =
          refused[i] || (sticks(before.nodes[i].state) && trial.nodes[i].state == NodeState::SLIDING);
  }
  if (solution.singular) solution.state = trial;
  solution.fresh.assign(state.nodes.size(), 0);
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
    solution.fresh[i] = in_contact(solution.state.nodes[i].state) && !in_contact(state.nodes[i].state);
  return solution;
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template WindowSolution<Dim> solve_window<Dim>(const ContactModel<Dim>&, const BodyView<Dim>&,             \
                                                 const PrescribedValues&, const ContactState<Dim>&,          \
                                                 const WindowProblem<Dim>&);                                 \
  template bool test_node<Dim>(const ContactModel<Dim>&, int, const std::vector<Pose<Dim>>&,                 \
                               const ContactNode<Dim>&, const Vector<Dim>&, const DecidingForce<Dim>&,       \
                               const Vector<Dim>&, EntryPlaces<Dim>&, const ActiveSetOptions&,               \
                               ContactNode<Dim>&);
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish
