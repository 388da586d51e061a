#include "iteration/condensed_iteration.hpp"
#include "contact/slip_motion.hpp"
#include "contact/tool_support.hpp"

namespace burnish {
namespace {

// Passes that change any number of states; later ones change one, which ends cycles; and all of them.
constexpr int MAX_TOGETHER = 8, MAX_PASSES = 12;

} // namespace

template <int Dim> void CondensedIteration<Dim>::begin() {
  m_again = false;
  m_passes = 0;
  m_refused.assign(m_iteration.state().nodes.size(), 0);
}

template <int Dim> void CondensedIteration<Dim>::prepare() {
  WindowProblem<Dim> problem;
  m_iteration.state_problem(problem);
  if (problem.adapt)
    stick_unsupported(m_iteration.model(), m_iteration.prescribed(), m_iteration.state(), m_refused);
  follow_ends(m_iteration.model(), m_iteration.state());
}

// States of the candidates by the solution of the present ones, before anything moves: passes as in solve_window.
template <int Dim>
bool CondensedIteration<Dim>::change_states(const typename Condensation<Dim>::Expansion& increment,
                                            const Eigen::VectorXd& u) {
  const ContactModel<Dim>& model = m_iteration.model();
  ContactState<Dim>& state = m_iteration.state();
  WindowProblem<Dim> problem;
  m_iteration.state_problem(problem);
  if (!problem.adapt) return false;
  ContactState<Dim> solved = state;
  move_by(model, increment, solved);
  const auto poses = model.poses(solved.q);
  const NodeTest<Dim> test(model, poses, problem.tolerances, *problem.entry);
  const std::vector<ContactNode<Dim>> before = state.nodes;
  std::vector<SurfaceForce<Dim>> own(before.size());
  for (std::size_t i = 0; i < before.size(); ++i)
    if (in_contact(before[i].state)) {
      const auto p = model.tools[before[i].tool]->point(poses[before[i].tool], solved.nodes[i].place);
      const Vector<Dim> F = increment.F.template segment<Dim>(Dim * i);
      own[i] = nodal_force(model, static_cast<int>(i), p, F).part;
    }
  const std::vector<DecidingForce<Dim>> deciding = deciding_forces(model, solved, own);
  bool any = false;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const int candidate = static_cast<int>(i), node = model.candidates[i];
    const Vector<Dim> F = increment.F.template segment<Dim>(Dim * i);
    const Vector<Dim> x =
        m_iteration.body().position(u, node) + increment.du.template segment<Dim>(Dim * node);
    const bool changed = test(candidate, solved.nodes[i], F, deciding[i], x, state.nodes[i]);
    if (changed && sticks(before[i].state) && state.nodes[i].state == NodeState::SLIDING) m_refused[i] = 1;
    any = any || changed;
    if (changed && m_passes >= MAX_TOGETHER) break; // the rest is tested in the next pass
  }
  follow_ends(model, state);
  return any;
}

template <int Dim>
void CondensedIteration<Dim>::advance(const typename Condensation<Dim>::Expansion& increment,
                                      Eigen::VectorXd& u) {
  ContactState<Dim>& state = m_iteration.state();
  m_iteration.policy().set_condensed();
  m_again = m_passes < MAX_PASSES && change_states(increment, u);
  if (m_again) {
    ++m_passes;
    return;
  }
  m_passes = 0;
  m_refused.assign(state.nodes.size(), 0);
  m_iteration.leave(u, {});
  u += increment.du;
  move_by(m_iteration.model(), increment, state);
  m_iteration.arrive(u);
}

template class CondensedIteration<2>;
template class CondensedIteration<3>;

} // namespace burnish
