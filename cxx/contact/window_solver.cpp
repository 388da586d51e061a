#include "contact/window_solver.hpp"
#include "contact/coupling.hpp"
#include "contact/driving_force.hpp"
#include "contact/idle_combinations.hpp"
#include "contact/slip_direction.hpp"
#include "contact/tool_support.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

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

// The idle coordinate that moves points of contact farthest, if that is beyond all that those under motion do; -1: none.
template <int Dim, class Idle>
int runaway(const std::vector<NodeLinearization<Dim>>& nodes, const PrescribedValues& prescribed,
            const Eigen::VectorXd& dq, double spacing, const Idle& idle) {
  constexpr double beyond = 10; // over the spacing of nodes and what coordinates under motion move by
  double driven = spacing, most = 0;
  int farthest = -1;
  for (const NodeLinearization<Dim>& node : nodes)
    for (std::size_t j = 0; node.in_contact && j < node.at.size(); ++j) {
      const int k = node.at[j];
      const double way = node.x_q.col(static_cast<Eigen::Index>(j)).norm() * std::abs(dq[k]);
      if (prescribed.is_motion[k]) driven = std::max(driven, way);
      if (way <= most || !idle(k)) continue;
      most = way;
      farthest = k;
    }
  return most > beyond * driven ? farthest : -1;
}

// Whether the forces F on the nodes balance what drives coordinate k, but for the change of their arms in this iteration.
template <int Dim>
bool balances(const std::vector<NodeLinearization<Dim>>& nodes, const Eigen::VectorXd& F, int k,
              double drive) {
  constexpr double nearly = 0.01;
  double sum = 0, size = std::abs(drive);
  for (std::size_t a = 0; a < nodes.size(); ++a)
    for (std::size_t j = 0; nodes[a].in_contact && j < nodes[a].at.size(); ++j) {
      if (nodes[a].at[j] != k) continue;
      const double part =
          nodes[a].x_q.col(static_cast<Eigen::Index>(j)).dot(F.template segment<Dim>(Dim * a));
      sum += part;
      size += std::abs(part);
    }
  return std::abs(sum - drive) <= nearly * size;
}

} // namespace

template <int Dim>
WindowSolver<Dim>::WindowSolver(const WindowProblem<Dim>& problem)
    : m_problem(problem), m_model(*problem.model), m_body(*problem.body), m_window(*problem.window),
      m_released(problem.start->nodes.size(), 0) {
  if (Dim == 3 && problem.adapt)
    m_by_friction = held_by_friction(m_model, *problem.prescribed, *problem.start);
  if (problem.iteration > 0) m_turning = m_by_friction;
  if (!m_by_friction.empty() && problem.added_stiffness.size() > 0) // as is a body between tools
    m_by_friction.assign(m_by_friction.size(), 1);
}

// The window's nodes that the block is made of: in contact, or with added stiffness.
template <int Dim>
std::vector<int> WindowSolver<Dim>::active_positions(const ContactState<Dim>& trial) const {
  const Eigen::VectorXd& added = m_problem.added_stiffness;
  std::vector<int> active;
  for (std::size_t w = 0; w < m_window.size(); ++w)
    if (in_contact(trial.nodes[m_window[w]].state) ||
        (added.size() > 0 && (added.template segment<Dim>(Dim * w).array() != 0).any()))
      active.push_back(static_cast<int>(w));
  return active;
}

// Deciding forces of the window's active nodes under the forces on them.
template <int Dim>
template <class Force>
std::vector<DecidingForce<Dim>>
WindowSolver<Dim>::deciding_at(const ContactState<Dim>& state, const std::vector<Pose<Dim>>& poses,
                               const std::vector<int>& active, const Force& force) const {
  std::vector<SurfaceForce<Dim>> own(state.nodes.size());
  for (const int w : active) {
    const ContactNode<Dim>& node = state.nodes[m_window[w]];
    if (!in_contact(node.state)) continue;
    const auto p = m_model.tools[node.tool]->point(poses[node.tool], node.place);
    own[m_window[w]] = nodal_force(m_model, m_window[w], p, force(m_window[w])).part;
  }
  return deciding_forces(m_model, state, poses, own);
}

// Linearizations of the active nodes at the start of the iteration, in the states of the trial.
template <int Dim>
std::vector<NodeLinearization<Dim>> WindowSolver<Dim>::linearize(const ContactState<Dim>& trial,
                                                                 const std::vector<int>& active,
                                                                 Eigen::VectorXd& offset) const {
  const auto poses = m_model.poses(m_problem.start->q);
  const auto force = [&](int candidate) { // a node that touches now, or again, carries no force yet
    if (!in_contact(m_problem.start->nodes[candidate].state) || m_released[candidate])
      return Vector<Dim>(Vector<Dim>::Zero());
    return Vector<Dim>(m_problem.R->template segment<Dim>(Dim * m_model.candidates[candidate]));
  };
  const std::vector<DecidingForce<Dim>> deciding = deciding_at(trial, poses, active, force);
  std::vector<NodeLinearization<Dim>> nodes;
  offset = Eigen::VectorXd::Zero(Dim * static_cast<Eigen::Index>(active.size()));
  for (std::size_t a = 0; a < active.size(); ++a) {
    const int candidate = m_window[active[a]], mesh_node = m_model.candidates[candidate];
    nodes.emplace_back();
    nodes.back().in_contact = in_contact(trial.nodes[candidate].state);
    if (!nodes.back().in_contact) continue;
    const ContactNode<Dim>& node = trial.nodes[candidate];
    NodeCones<Dim> cones = cones_of(m_model, trial, poses, deciding, candidate, m_problem.friction_tangent);
    if (m_problem.friction_tangent == FrictionTangent::CONSISTENT)
      begin_turn(m_model, BeginningSlips<Dim>{m_by_friction, trial, poses, deciding}, candidate, cones);
    nodes.back() = linearize_node(m_model, node, candidate, poses, force(candidate), m_problem.terms, &cones);
    if (!m_model.couplings.empty())
      eliminate_followers(m_model, m_problem.start->q, m_problem.terms, nodes.back());
    offset.template segment<Dim>(Dim * a) =
        offset_to(m_model, candidate, nodes.back().point, m_body.position(*m_problem.u, mesh_node));
  }
  return nodes;
}

// A coordinate that nothing resists keeps its place in this pass where that leaves it in balance: turns of a body that only free
// tools hold cost nothing until they press. In space, where all nodes may slide and the next pass has others, it is one without a
// force of its own, also where it is resisted so little that it runs away.
template <int Dim>
ContactBlockSolution<Dim> WindowSolver<Dim>::solved_with_idle(PrescribedValues& prescribed,
                                                              const ContactBlockInput<Dim>& input,
                                                              bool& held_back) const {
  const Eigen::VectorXd& q = m_problem.start->q;
  auto block = solve_contact_block(m_model, prescribed, q, input);
  if (!m_problem.adapt) return block;
  const Eigen::VectorXd drive = driving_force(m_model, prescribed, q).value;
  const auto may_rest = [&](int k) {
    return !prescribed.is_motion[k] && !prescribed.is_held(k) && !m_model.coupling_of(k) &&
           (Dim == 2 || drive[k] == 0);
  };
  for (;;) {
    const bool looks = Dim == 3 && !block.singular && !m_lets_run;
    const int far = looks ? runaway(*input.nodes, prescribed, block.dq, m_body.spacing, may_rest) : -1;
    const int k = block.singular ? block.weakest_coordinate : far;
    if (k < 0 || !may_rest(k)) return block;
    held_back = held_back || far >= 0;
    prescribed.is_motion[k] = 1;
    prescribed.value[k] = m_problem.resting ? (*m_problem.resting)[k] : q[k];
    auto at_rest = solve_contact_block(m_model, prescribed, q, input);
    if (Dim == 2 && !at_rest.singular && !balances<Dim>(*input.nodes, at_rest.F, k, drive[k])) return block;
    block = std::move(at_rest);
  }
}

template <int Dim>
bool WindowSolver<Dim>::solve(const ContactState<Dim>& trial, WindowSolution<Dim>& out) const {
  const std::vector<int> active = active_positions(trial);
  const FreeComponents free = free_components(m_model, m_window, active);
  out.weakest_coordinate = -1;
  out.singular = out.indefinite = !m_problem.flexibility->select(free.in_window);
  if (out.singular) return false;
  ContactBlockInput<Dim> input;
  const auto nodes = linearize(trial, active, input.offset);
  input.nodes = &nodes;
  input.free = &free.in_block;
  input.flexibility = m_problem.flexibility;
  input.free_increment = of_nodes<Dim>(m_problem.free_increment, active);
  if (m_problem.added_stiffness.size() > 0)
    input.added_stiffness = of_nodes<Dim>(m_problem.added_stiffness, active);
  input.test_stability = m_problem.test_stability;
  const Eigen::VectorXd& resting = m_problem.resting ? *m_problem.resting : m_problem.start->q;
  PrescribedValues prescribed = with_idle_given(m_model, *m_problem.prescribed, trial, resting);
  out.held_back = false;
  const auto block = solved_with_idle(prescribed, input, out.held_back);
  out.unstable = block.unstable;
  out.singular = block.singular;
  out.weakest_coordinate = block.weakest_coordinate;
  if (block.singular) return false;
  out.state = trial;
  out.state.q = m_problem.start->q + block.dq;
  follow(m_model, out.state.q);
  out.F = out.load = Eigen::VectorXd::Zero(Dim * static_cast<Eigen::Index>(m_window.size()));
  for (std::size_t a = 0; a < active.size(); ++a) {
    ContactNode<Dim>& node = out.state.nodes[m_window[active[a]]];
    if (nodes[a].sliding)
      node.place = m_model.tools[node.tool]->surface().moved(
          node.place, block.slip.col(static_cast<Eigen::Index>(a)) / nodes[a].point.size);
    out.F.template segment<Dim>(Dim * active[a]) = block.F.template segment<Dim>(Dim * a);
    out.load.template segment<Dim>(Dim * active[a]) = block.load.template segment<Dim>(Dim * a);
  }
  follow_ends(m_model, out.state);
  return true;
}

template <int Dim>
int WindowSolver<Dim>::test(const WindowSolution<Dim>& solution, ContactState<Dim>& trial,
                            std::vector<double>& severity) const {
  const auto poses = m_model.poses(solution.state.q);
  Eigen::VectorXd du = m_problem.free_increment;
  m_problem.flexibility->add_product(solution.load, du);
  std::vector<int> all(m_window.size()), place(solution.state.nodes.size(), -1);
  for (std::size_t w = 0; w < m_window.size(); ++w) place[m_window[w]] = all[w] = static_cast<int>(w);
  const std::vector<DecidingForce<Dim>> deciding = deciding_at(solution.state, poses, all, [&](int i) {
    return Vector<Dim>(solution.F.template segment<Dim>(Eigen::Index{Dim} * place[i]));
  });
  const NodeTest<Dim> test(m_model, poses, m_problem.tolerances, *m_problem.entry);
  int changes = 0;
  for (std::size_t w = 0; w < m_window.size(); ++w) {
    const int i = m_window[w];
    const Vector<Dim> x =
        m_body.position(*m_problem.u, m_model.candidates[i]) + du.template segment<Dim>(Dim * w);
    const Vector<Dim> F = solution.F.template segment<Dim>(Dim * w);
    const ContactNode<Dim>& solved = solution.state.nodes[i];
    if (in_contact(solved.state)) {
      const Vector<Dim> n = m_model.tools[solved.tool]->point(poses[solved.tool], solved.place).n;
      Eigen::Matrix<double, Dim, Dim> C;
      for (int r = 0; r < Dim; ++r)
        for (int c = 0; c < Dim; ++c)
          C(r, c) =
              m_problem.flexibility->entry(Dim * static_cast<int>(w) + r, Dim * static_cast<int>(w) + c);
      const double own = n.dot(C * n);
      severity[i] = -(m_model.is_weightless(i) ? deciding[i].normal : F.dot(n)) * own;
    } else
      severity[i] = -nearest_tool(m_model, poses, x, m_problem.entry->nodes[i], i).foot.gap;
    changes += test(i, solved, F, deciding[i], x, trial.nodes[i]);
  }
  return changes;
}

// In the plane a force gives a node that comes back no more than the turn of its tangent; in space also the stiffness across
// its slip, which holds it off its cone, so that it would be released and touch again without end.
template <int Dim>
void WindowSolver<Dim>::note_released(const ContactState<Dim>& before, const ContactState<Dim>& after) {
  if (Dim == 2) return;
  for (const int i : m_window)
    if (in_contact(before.nodes[i].state) && !in_contact(after.nodes[i].state)) m_released[i] = 1;
}

template class WindowSolver<2>;
template class WindowSolver<3>;

} // namespace burnish
