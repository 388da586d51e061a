#include "stepping/active_set.hpp"
#include <cmath>

namespace burnish {
namespace {

template <int Dim>
std::vector<int> active_positions(const ContactState<Dim>& state, const WindowProblem<Dim>& problem) {
  const std::vector<int>& window = *problem.window;
  std::vector<int> active; // in contact, or shifted
  for (std::size_t w = 0; w < window.size(); ++w)
    if (in_contact(state.nodes[window[w]].state) ||
        (problem.shift.size() > 0 && (problem.shift.template segment<Dim>(Dim * w).array() != 0).any()))
      active.push_back(static_cast<int>(w));
  return active;
}

template <int Dim> Eigen::MatrixXd sub_matrix(const Eigen::MatrixXd& C, const std::vector<int>& at) {
  const Eigen::Index n = static_cast<Eigen::Index>(at.size());
  Eigen::MatrixXd result(Dim * n, Dim * n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      result.template block<Dim, Dim>(Dim * i, Dim * j) =
          C.template block<Dim, Dim>(Dim * at[i], Dim * at[j]);
  return result;
}

// Dense block of the active nodes at fixed states; F on the window and the states moved by ds, dq.
template <int Dim>
bool solve_active(const ContactModel<Dim>& model, const BodyView<Dim>& body, const Program& program,
                  const ContactState<Dim>& start, const ContactState<Dim>& trial,
                  const WindowProblem<Dim>& problem, WindowSolution<Dim>& out) {
  const std::vector<int>& window = *problem.window;
  const std::vector<int> active = active_positions(trial, problem);
  const auto poses = model.poses(start.q);
  std::vector<NodeLinearization<Dim>> nodes;
  ContactBlockInput<Dim> input;
  input.offset = Eigen::VectorXd::Zero(Dim * active.size());
  input.free_increment.resize(Dim * active.size());
  for (std::size_t a = 0; a < active.size(); ++a) {
    const int candidate = window[active[a]], mesh_node = model.candidates[candidate];
    const bool was = in_contact(start.nodes[candidate].state);
    const Vector<Dim> R =
        was ? Vector<Dim>(problem.R->template segment<Dim>(Dim * mesh_node)) : Vector<Dim>::Zero();
    if (in_contact(trial.nodes[candidate].state)) {
      nodes.push_back(linearize_node(model, trial.nodes[candidate], candidate, poses, R, problem.terms));
      input.offset.template segment<Dim>(Dim * a) =
          offset_to(model, candidate, nodes.back().point, body.position(*problem.u, mesh_node));
    } else {
      nodes.emplace_back();
      nodes.back().loose = true;
    }
    input.free_increment.template segment<Dim>(Dim * a) =
        problem.free_increment.template segment<Dim>(Dim * active[a]);
  }
  if (problem.shift.size() > 0) {
    input.shift.resize(Dim * active.size());
    for (std::size_t a = 0; a < active.size(); ++a)
      input.shift.template segment<Dim>(Dim * a) = problem.shift.template segment<Dim>(Dim * active[a]);
  }
  const Eigen::MatrixXd C = sub_matrix<Dim>(*problem.flexibility, active);
  input.nodes = &nodes;
  input.flexibility = &C;
  const auto block = solve_contact_block(model, program, start.q, input);
  out.singular = block.singular;
  out.weakest_coordinate = block.weakest_coordinate;
  if (block.singular) return false;
  out.state = trial;
  out.state.q = start.q + block.dq;
  out.F = out.load = Eigen::VectorXd::Zero(Dim * static_cast<Eigen::Index>(window.size()));
  for (std::size_t a = 0; a < active.size(); ++a) {
    out.state.nodes[window[active[a]]].s[0] += block.ds[a];
    out.F.template segment<Dim>(Dim * active[a]) = block.F.template segment<Dim>(Dim * a);
    out.load.template segment<Dim>(Dim * active[a]) = block.load.template segment<Dim>(Dim * a);
  }
  return true;
}

// Tests a node in contact; returns true if its state changed. `solved` holds s + ds, `trial` is changed.
template <int Dim>
bool test_contact(const FrictionLaw& law, const SurfacePoint<Dim>& p, const NodalForce<Dim>& force,
                  const ContactNode<Dim>& solved, ContactNode<Dim>& trial,
                  const WindowProblem<Dim>& problem) {
  const double length = p.x_s.col(0).norm(), N = force.N, T = force.T;
  if (trial.state == NodeState::SLIDING) {
    if (N < -problem.force_tolerance) {
      trial.state = NodeState::FREE;
      trial.slip_sign = 0;
      return true;
    }
    if (law.frictionless()) return false;
    if ((solved.s - trial.s_ref)[0] * trial.slip_sign * length < -0.1 * problem.gap_tolerance) {
      trial.state = NodeState::STICKING;
      trial.s = trial.s_ref;
      trial.slip_sign = 0;
      return true;
    }
    return false;
  }
  if (N < -problem.force_tolerance && law.sticks_always()) {
    trial.state = NodeState::FREE;
    return true;
  }
  if (N < -problem.force_tolerance ||
      std::abs(T) > law.limit(std::max(N, 0.), trial.area) + problem.force_tolerance) {
    trial.state = NodeState::SLIDING; // friction opposes slip: the tangential force tells its direction
    trial.slip_sign = law.frictionless() ? 0 : (T > 0 ? -1 : 1);
    return true;
  }
  return false;
}

// A node that sticks always and cannot stay at its place (twice released in this step) may touch anew elsewhere.
template <int Dim>
bool returns(const ContactModel<Dim>& model, int candidate, int tool, const ContactNode<Dim>& entry,
             int releases) {
  return entry.tool == tool && !(releases > 1 && model.law(candidate, tool).sticks_always());
}

// A free node that would penetrate comes into contact where it would have touched.
template <int Dim>
bool test_free(const ContactModel<Dim>& model, int candidate, const std::vector<Pose<Dim>>& poses,
               const Vector<Dim>& x, const ContactNode<Dim>& entry, int releases, ContactNode<Dim>& trial,
               double gap_tolerance) {
  const auto nearest = nearest_tool(model, poses, x, entry, candidate);
  if (!(nearest.foot.gap < -gap_tolerance)) return false;
  const auto foot = model.tools[nearest.tool]->surface(poses[nearest.tool], nearest.foot.s);
  if (normal_lift(model, candidate, foot.n).isZero()) return false; // the support holds it
  const bool frictionless = model.law(candidate, nearest.tool).frictionless();
  trial.tool = nearest.tool;
  trial.s_ref = returns(model, candidate, nearest.tool, entry, releases) ? entry.s_ref : nearest.foot.s;
  trial.s = frictionless ? nearest.foot.s : trial.s_ref;
  trial.state = frictionless ? NodeState::SLIDING : NodeState::STICKING;
  trial.slip_sign = 0;
  return true;
}

// One pass of tests over the window; returns the number of changes.
template <int Dim>
int test_window(const ContactModel<Dim>& model, const BodyView<Dim>& body, const WindowProblem<Dim>& problem,
                const WindowSolution<Dim>& solution, ContactState<Dim>& trial) {
  const std::vector<int>& window = *problem.window;
  const auto poses = model.poses(solution.state.q);
  const Eigen::VectorXd du = problem.free_increment + *problem.flexibility * solution.load;
  int changes = 0;
  for (std::size_t w = 0; w < window.size(); ++w) {
    const int i = window[w];
    ContactNode<Dim>& node = trial.nodes[i];
    if (in_contact(node.state)) {
      const auto p = model.tools[node.tool]->surface(poses[node.tool], solution.state.nodes[i].s);
      const auto force = nodal_force(model, i, p, Vector<Dim>(solution.F.template segment<Dim>(Dim * w)));
      changes += test_contact(model.law(i, node.tool), p, force, solution.state.nodes[i], node, problem);
      if (!in_contact(node.state)) ++(*problem.releases)[i];
    } else {
      const Vector<Dim> x =
          body.position(*problem.u, model.candidates[i]) + du.template segment<Dim>(Dim * w);
      changes += test_free(model, i, poses, x, (*problem.entry)[i], (*problem.releases)[i], node,
                           problem.gap_tolerance);
    }
  }
  return changes;
}

// A body that only its tools hold slides one way before the neutral point of a tool, the other way behind it.
// If no node sticks there, nothing but the curvature of the contact holds it along the tool, and the solution
// is far off: the node that slipped least sticks, unless it could not before. Returns whether one was chosen.
template <int Dim>
bool stick_at_neutral_point(const ContactModel<Dim>& model, ContactState<Dim>& state,
                            const std::vector<char>& refused) {
  int best = -1;
  double smallest = 0;
  std::vector<char> forward(model.tools.size(), 0), backward(model.tools.size(), 0);
  bool neutral = false;
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    const auto& node = state.nodes[i];
    if (!in_contact(node.state) || model.is_held(static_cast<int>(i))) continue;
    if (holds(node.state) || model.friction[node.tool]->frictionless()) return false;
    (node.slip_sign > 0 ? forward : backward)[node.tool] = 1;
    neutral = neutral || (forward[node.tool] && backward[node.tool]);
    const double slip = std::abs((node.s - node.s_ref)[0]);
    if (refused[i] || (best >= 0 && slip >= smallest)) continue;
    best = static_cast<int>(i);
    smallest = slip;
  }
  if (!neutral || best < 0) return false;
  auto& node = state.nodes[best];
  node.state = NodeState::STICKING;
  node.s = node.s_ref;
  node.slip_sign = 0;
  return true;
}

} // namespace

template <int Dim>
int ensure_support(const ContactModel<Dim>& model, const Program& program, ContactState<Dim>& state,
                   const std::vector<char>& refused) {
  const auto poses = model.poses(state.q);
  for (std::size_t t = 0; t < model.tools.size(); ++t) {
    if (model.friction[t]->frictionless()) continue;
    int best = -1;
    bool sticks = false, any = false;
    Eigen::VectorXd normal, size;
    double smallest = 0;
    for (std::size_t i = 0; i < state.nodes.size(); ++i) {
      const auto& node = state.nodes[i];
      if (!in_contact(node.state) || node.tool != static_cast<int>(t)) continue;
      if (model.is_held(static_cast<int>(i))) continue;
      sticks = sticks || holds(node.state);
      const auto p = model.tools[t]->surface(poses[t], node.s);
      const Eigen::VectorXd xn = (p.x_q.transpose() * p.n).cwiseAbs(), xx = p.x_q.colwise().norm();
      normal = any ? Eigen::VectorXd(normal.cwiseMax(xn)) : xn;
      size = any ? Eigen::VectorXd(size.cwiseMax(xx)) : xx;
      const bool last_resort = !refused.empty() && refused[i];
      const double slip = std::abs((node.s - node.s_ref)[0]) + (last_resort ? 1e300 : 0);
      if (best < 0 || slip < smallest) {
        best = static_cast<int>(i);
        smallest = slip;
      }
      any = true;
    }
    if (!any || sticks) continue;
    for (Eigen::Index k = 0; k < normal.size(); ++k)
      if (!program.is_motion[model.first[t] + k] && normal[k] <= 1e-9 * size[k]) {
        auto& node = state.nodes[best];
        node.state = NodeState::STICKING;
        node.s = node.s_ref;
        node.slip_sign = 0;
        return best;
      }
  }
  return -1;
}

template <int Dim>
WindowSolution<Dim> solve_window(const ContactModel<Dim>& model, const BodyView<Dim>& body,
                                 const Program& program, const ContactState<Dim>& state,
                                 const WindowProblem<Dim>& problem) {
  WindowSolution<Dim> solution;
  ContactState<Dim> trial = state;
  std::vector<char> refused(state.nodes.size(), 0); // nodes that could not stick
  constexpr int max_trials = 4;
  int trials = 0;
  for (solution.passes = 1;; ++solution.passes) {
    if (problem.adapt) ensure_support(model, program, trial, refused);
    if (problem.adapt && problem.shift.size() > 0 && trials < max_trials)
      trials += stick_at_neutral_point(model, trial, refused);
    if (!solve_active(model, body, program, state, trial, problem, solution)) break;
    if (!problem.adapt || solution.passes >= problem.max_passes) break;
    const ContactState<Dim> before = trial;
    if (test_window(model, body, problem, solution, trial) == 0) break;
    for (std::size_t i = 0; i < refused.size(); ++i)
      refused[i] = refused[i] || (holds(before.nodes[i].state) && trial.nodes[i].state == NodeState::SLIDING);
  }
  if (solution.singular) solution.state = trial;
  solution.fresh.assign(state.nodes.size(), 0);
  for (std::size_t i = 0; i < state.nodes.size(); ++i)
    solution.fresh[i] = in_contact(solution.state.nodes[i].state) && !in_contact(state.nodes[i].state);
  return solution;
}

template int ensure_support<2>(const ContactModel<2>&, const Program&, ContactState<2>&,
                               const std::vector<char>&);
template WindowSolution<2> solve_window<2>(const ContactModel<2>&, const BodyView<2>&, const Program&,
                                           const ContactState<2>&, const WindowProblem<2>&);

} // namespace burnish
