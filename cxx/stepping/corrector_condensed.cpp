// Iterations by the condensed system instead of factorize and correct.
#include "contact/slip_motion.hpp"
#include "contact/tool_support.hpp"
#include "stepping/corrector.hpp"

namespace burnish {

template <int Dim> void Corrector<Dim>::prepare_condensed() {
  if (m_adapt) stick_unsupported(m_model, m_prescribed, m_state, m_refused);
  follow_ends(m_model, m_state);
}

// Elastic moduli while points go to and fro between elastic and plastic; none once the residual falls (ALGORITHMS.md 5.8).
template <int Dim> void Corrector<Dim>::choose_blend(double residual) {
  if (m_last_residual < 0) return;
  if (residual > m_options.condensed_slow * m_last_residual) {
    ++m_step_factorizations;
    m_falls = 0;
  } else if (++m_falls >= m_options.condensed_falls) {
    m_step_factorizations = 0;
  }
}

// States of the candidates by the solution of the present ones, before anything moves: passes as in solve_window.
template <int Dim>
bool Corrector<Dim>::change_states(const typename Condensation<Dim>::Expansion& increment,
                                   const Eigen::VectorXd& u) {
  ContactState<Dim> solved = m_state;
  move_by(m_model, increment, solved);
  const auto poses = m_model.poses(solved.q);
  const ActiveSetOptions options = active_set_options();
  const std::vector<ContactNode<Dim>> before = m_state.nodes;
  std::vector<SurfaceForce<Dim>> own(before.size());
  for (std::size_t i = 0; i < before.size(); ++i)
    if (in_contact(before[i].state)) {
      const auto p = m_model.tools[before[i].tool]->point(poses[before[i].tool], solved.nodes[i].place);
      const Vector<Dim> F = increment.F.template segment<Dim>(Dim * i);
      own[i] = nodal_force(m_model, static_cast<int>(i), p, F).part;
    }
  const std::vector<DecidingForce<Dim>> deciding = deciding_forces(m_model, solved, own);
  bool any = false;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const int candidate = static_cast<int>(i), node = m_model.candidates[i];
    const Vector<Dim> F = increment.F.template segment<Dim>(Dim * i);
    const Vector<Dim> x = m_body.position(u, node) + increment.du.template segment<Dim>(Dim * node);
    const bool changed = test_node(m_model, candidate, poses, solved.nodes[i], F, deciding[i], x, m_entry,
                                   options, m_state.nodes[i]);
    if (changed && sticks(before[i].state) && m_state.nodes[i].state == NodeState::SLIDING) m_refused[i] = 1;
    any = any || changed;
    if (changed && m_passes >= m_options.max_together) break; // the rest is tested in the next pass
  }
  follow_ends(m_model, m_state);
  return any;
}

template <int Dim>
void Corrector<Dim>::advance(const typename Condensation<Dim>::Expansion& increment, Eigen::VectorXd& u) {
  m_condensed = true;
  if (m_passes == 0) m_nodes_before = m_state.nodes;
  m_again = m_adapt && m_passes < m_options.max_state_passes && change_states(increment, u);
  if (m_again) {
    ++m_passes;
    return;
  }
  m_passes = 0;
  m_refused.assign(m_state.nodes.size(), 0);
  ++m_iteration;
  ++m_counts.iterations;
  m_u_before = u;
  m_q_before = m_state.q;
  u += increment.du;
  move_by(m_model, increment, m_state);
  for (std::size_t i = 0; i < m_state.nodes.size(); ++i)
    m_fresh[i] = in_contact(m_state.nodes[i].state) && !in_contact(m_nodes_before[i].state);
  project(u, false);
}

// clang-format off
#define BURNISH_CONDENSED(Dim)                                                                                         \
  template void Corrector<Dim>::prepare_condensed();                                                                   \
  template void Corrector<Dim>::choose_blend(double);                                                                  \
  template bool Corrector<Dim>::change_states(const Condensation<Dim>::Expansion&, const Eigen::VectorXd&);            \
  template void Corrector<Dim>::advance(const Condensation<Dim>::Expansion&, Eigen::VectorXd&);
// clang-format on
BURNISH_CONDENSED(2)
BURNISH_CONDENSED(3)

} // namespace burnish
