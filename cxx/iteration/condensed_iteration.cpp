#include "iteration/condensed_iteration.hpp"
#include "contact/slip_motion.hpp"
#include "contact/tool_support.hpp"
#include <numeric>

namespace burnish {
namespace {

constexpr int MAX_PASSES = 40; // each of them a sparse factor

// Deciding forces of a solution. severity, per candidate in contact: its tension over the tolerance.
// @param F force of the tool on every candidate [force]
template <int Dim>
std::vector<DecidingForce<Dim>>
predicted_forces(const ContactModel<Dim>& model, const ContactState<Dim>& solved,
                 const std::vector<Pose<Dim>>& poses, const Eigen::VectorXd& F, const Tolerances& tolerances,
                 std::vector<double>& severity) {
  std::vector<SurfaceForce<Dim>> own(solved.nodes.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    const ContactNode<Dim>& node = solved.nodes[i];
    if (!in_contact(node.state)) continue;
    const auto p = model.tools[node.tool]->point(poses[node.tool], node.place);
    own[i] = nodal_force(model, static_cast<int>(i), p, Vector<Dim>(F.template segment<Dim>(Dim * i))).part;
  }
  const std::vector<DecidingForce<Dim>> deciding = deciding_forces(model, solved, poses, own);
  for (std::size_t i = 0; i < own.size(); ++i)
    if (in_contact(solved.nodes[i].state)) {
      const double N = model.is_weightless(static_cast<int>(i)) ? deciding[i].normal : own[i].N;
      severity[i] = -N / tolerances.of(solved.nodes[i].tool).force;
    }
  return deciding;
}

} // namespace

template <int Dim>
CondensedIteration<Dim>::CondensedIteration(Iteration<Dim>& iteration)
    : m_iteration(iteration), m_candidates(iteration.state().nodes.size()) {
  std::iota(m_candidates.begin(), m_candidates.end(), 0);
}

template <int Dim> void CondensedIteration<Dim>::begin() {
  m_gave_up = false;
  begin_passes();
}

template <int Dim> void CondensedIteration<Dim>::begin_passes() {
  m_again = false;
  m_passes = 0;
  m_refused.assign(m_candidates.size(), 0);
  m_choice.emplace(m_iteration.model(), m_candidates);
  m_by_friction.clear();
  WindowProblem<Dim> problem;
  m_iteration.state_problem(problem);
  if (Dim == 3 && problem.adapt)
    m_by_friction = held_by_friction(m_iteration.model(), m_iteration.prescribed(), m_iteration.state());
  m_turning = problem.iteration == 0 ? std::vector<char>() : m_by_friction;
  m_supports = 0;
}

template <int Dim> void CondensedIteration<Dim>::prepare() {
  WindowProblem<Dim> problem;
  m_iteration.state_problem(problem);
  if (problem.adapt) relieve_vertices(m_iteration.model(), m_iteration.state());
  while (problem.adapt && (Dim == 2 || m_supports < MAX_SUPPORTS) &&
         stick_unsupported(m_iteration.model(), m_iteration.prescribed(), m_iteration.state(), m_refused,
                           m_turning, true) >= 0)
    ++m_supports;
  follow_ends(m_iteration.model(), m_iteration.state());
}

// States of the candidates by the solution of the present ones, before anything moves: passes as in solve_window. Returns how many
// contradict it.
template <int Dim>
int CondensedIteration<Dim>::change_states(const typename Condensation<Dim>::Expansion& increment,
                                           const Eigen::VectorXd& u) {
  const ContactModel<Dim>& model = m_iteration.model();
  ContactState<Dim>& state = m_iteration.state();
  WindowProblem<Dim> problem;
  m_iteration.state_problem(problem);
  if (!problem.adapt) return 0;
  ContactState<Dim> solved = state;
  move_by(model, increment, solved);
  const auto poses = model.poses(solved.q), start_poses = model.poses(state.q);
  const NodeTest<Dim> test(model, poses, problem.tolerances, *problem.entry);
  const ContactState<Dim> before = state;
  std::vector<double> severity(m_candidates.size(), 0);
  const auto place_of = [&](int i, const ContactState<Dim>& at, const Vector<Dim>& x, const auto& tools) {
    return model.tools[at.nodes[i].tool]->foot(tools[at.nodes[i].tool], x, at.nodes[i].place.hint);
  };
  const std::vector<DecidingForce<Dim>> deciding =
      predicted_forces(model, solved, poses, increment.F, problem.tolerances, severity);
  int changes = 0;
  for (const int i : m_candidates) {
    const int node = model.candidates[i];
    const Vector<Dim> F = increment.F.template segment<Dim>(Dim * i),
                      start = m_iteration.body().position(u, node),
                      x = start + increment.du.template segment<Dim>(Dim * node);
    changes += test(i, solved.nodes[i], F, deciding[i], x, state.nodes[i]);
    if (!in_contact(before.nodes[i].state) && in_contact(state.nodes[i].state))
      severity[i] = -place_of(i, state, x, poses).gap / problem.tolerances.gap;
    if (sticks(before.nodes[i].state) && state.nodes[i].state == NodeState::SLIDING)
      state.nodes[i].place = place_of(i, state, start, start_poses).place;
  }
  if (changes == 0) return 0;
  m_choice->choose(before, severity, state);
  for (const int i : m_candidates)
    if (sticks(before.nodes[i].state) && state.nodes[i].state == NodeState::SLIDING) m_refused[i] = 1;
  follow_ends(model, state);
  return changes;
}

template <int Dim>
void CondensedIteration<Dim>::advance(const typename Condensation<Dim>::Expansion& increment,
                                      Eigen::VectorXd& u) {
  ContactState<Dim>& state = m_iteration.state();
  m_iteration.policy().set_condensed(true);
  const ContactState<Dim> present = state;
  const int contradictions = change_states(increment, u);
  m_again = contradictions > 0 && ++m_passes < MAX_PASSES;
  if (m_again) return;
  state = present; // that were solved with
  m_gave_up = m_iteration.solved(contradictions) == StepStatus::FAILED;
  m_iteration.leave(u, {});
  u += increment.du;
  move_by(m_iteration.model(), increment, state);
  m_iteration.arrive(u);
  begin_passes();
}

template class CondensedIteration<2>;
template class CondensedIteration<3>;

} // namespace burnish
