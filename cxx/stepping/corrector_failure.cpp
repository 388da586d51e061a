// Where the iteration goes wrong: ways back, a tangent that no longer helps, the reason of a failure (ALGORITHMS.md 5.2, 5.6).
#include "contact/coupling.hpp"
#include "stepping/corrector.hpp"
#include <sstream>

namespace burnish {

// The iterate goes half way back to the one before.
template <int Dim> StepStatus Corrector<Dim>::backtrack(Eigen::VectorXd& u) {
  ++m_backtracks;
  ++m_counts.backtracks;
  u = 0.5 * (u + m_u_before);
  m_state.q = 0.5 * (m_state.q + m_q_before);
  follow(m_model, m_state.q);
  project(u, true);
  m_u_before.resize(0);
  m_mixer.clear();
  return StepStatus::BACKTRACKED;
}

// The iterate before, with its states: one taken half way back would keep the states of the bad iterate.
template <int Dim> StepStatus Corrector<Dim>::go_back(Eigen::VectorXd& u) {
  ++m_backtracks;
  ++m_counts.backtracks;
  if (m_condensed) ++m_step_factorizations;
  u = m_u_before;
  m_state.q = m_q_before;
  m_state.nodes = m_nodes_before;
  m_u_before.resize(0);
  m_mixer.clear();
  m_went_back = true;
  return StepStatus::BACKTRACKED;
}

// Whether the residual has hardly fallen over several iterations with one tangent.
template <int Dim> bool Corrector<Dim>::stalls(double residual, double allowed) {
  const bool first = m_iteration <= m_options.stall_after; // steps that converge soon keep their tangent
  if (!first && ++m_stall_iterations < m_options.stall_after) return false;
  const bool stalled = !first && residual > m_options.stall * m_stall_residual && residual > allowed;
  m_stall_iterations = 0;
  m_stall_residual = residual;
  return stalled;
}

template <int Dim> std::string Corrector<Dim>::reason_of_failure(double scale) const {
  std::ostringstream text;
  text << "no convergence in " << m_iteration << " iterations: residual " << m_balance.residual
       << ", allowed " << allowed(scale) << ", " << m_balance.inconsistent << " inconsistent contact states";
  if (m_balance.residual > allowed(scale)) {
    if (m_rounding > allowed(scale))
      text << ": rounding leaves up to " << m_rounding
           << ", the mesh is too large or too slender for this load";
  } else if (m_balance.friction > (1 + m_options.tolerance) * m_balance.friction_limit) {
    text << ": the forces balance with friction that adds up to " << m_balance.friction
         << " over the contact nodes, whose limits add up to " << m_balance.friction_limit
         << ": too little to balance a coordinate under force";
  } else {
    text << ": the forces balance, but states cycle";
  }
  return text.str();
}

// clang-format off
#define BURNISH_FAILURE(Dim)                                                                                           \
  template StepStatus Corrector<Dim>::backtrack(Eigen::VectorXd&);                                                     \
  template StepStatus Corrector<Dim>::go_back(Eigen::VectorXd&);                                                       \
  template bool Corrector<Dim>::stalls(double, double);                                                                \
  template std::string Corrector<Dim>::reason_of_failure(double) const;
// clang-format on
BURNISH_FAILURE(2)
BURNISH_FAILURE(3)

} // namespace burnish
