#include "contact/support_by_friction.hpp"
#include "base/decompositions.hpp"
#include "contact/rigid_modes.hpp"
#include "contact/tool_support.hpp"
#include <algorithm>

namespace burnish {
namespace {

constexpr int MAX_NEUTRAL_TRIALS = 4; // a neutral point is looked for that often (stick_at_neutral_point)
constexpr int SETTLED = 4;            // iterations after which no neutral point is looked for in space
constexpr int MAX_LOSSES = 4;         // passes that have lost the last node that stuck, and go on
constexpr int MAX_CYCLES = 4;         // nodes that stick on trial where states cycle

// Whether no node sticks, but for those of some tools.
template <int Dim> bool none_sticks(const ContactState<Dim>& state, const std::vector<char>& without = {}) {
  return std::none_of(state.nodes.begin(), state.nodes.end(), [&](const auto& node) {
    return sticks(node.state) && (without.empty() || !without[node.tool]);
  });
}

// Whether contact without friction would hold the body: its rigid motions that no support takes press against tools, by their share
// along the normals, squared.
template <int Dim> bool normals_hold(const WindowProblem<Dim>& problem, const ContactState<Dim>& state) {
  constexpr double unsupported = 1e-9, held = 0.1;
  const BodyView<Dim>& body = *problem.body;
  const ContactModel<Dim>& model = *problem.model;
  const RigidModes<Dim> motions(body, body.position(*problem.u, model.candidates[0]));
  const SymmetricEigen supports = symmetric_eigen(motions.resisted_by_supports(body, *problem.u));
  const Eigen::Index left = (supports.values.array() <= unsupported * supports.values.maxCoeff()).count();
  if (left == 0) return true;
  typename RigidModes<Dim>::Form pressed = RigidModes<Dim>::Form::Zero();
  const auto poses = model.poses(state.q);
  int touching = 0;
  for (std::size_t i = 0; i < state.nodes.size(); ++i) {
    const ContactNode<Dim>& node = state.nodes[i];
    if (!in_contact(node.state)) continue;
    const Vector<Dim> n = model.tools[node.tool]->point(poses[node.tool], node.place).n;
    const auto along = (n.transpose() * motions(body.position(*problem.u, model.candidates[i]))).eval();
    pressed += along.transpose() * along;
    ++touching;
  }
  const Eigen::MatrixXd free = supports.vectors.leftCols(left);
  return symmetric_eigen(free.transpose() * pressed * free).values[0] > held * touching;
}

} // namespace

template <int Dim>
SupportByFriction<Dim>::SupportByFriction(const WindowProblem<Dim>& problem)
    : m_problem(problem), m_model(*problem.model), m_refused(problem.start->nodes.size(), 0),
      m_floating(problem.added_stiffness.size() > 0) {
  const bool turns =
      Dim == 3 && problem.iteration > 0 && (problem.iteration >= SETTLED || none_sticks(*problem.start));
  if (turns) m_trials = MAX_NEUTRAL_TRIALS;
  if (m_floating) m_idle = held_by_friction(m_model, *problem.prescribed, *problem.start);
}

template <int Dim>
void SupportByFriction<Dim>::begin_pass(const WindowSolver<Dim>& solver, ContactState<Dim>& trial) {
  relieve_vertices(m_model, trial);
  while ((Dim == 2 || m_supports < MAX_SUPPORTS) &&
         stick_unsupported(m_model, *m_problem.prescribed, trial, m_refused, solver.turning(), true) >= 0)
    ++m_supports;
  if (m_floating && m_trials < MAX_NEUTRAL_TRIALS)
    m_trials += stick_at_neutral_point(m_model, trial, m_refused);
}

template <int Dim> bool SupportByFriction<Dim>::regain(ContactState<Dim>& trial) {
  if (is_lost(trial) && ++m_losses <= MAX_LOSSES) {
    m_refused.assign(m_refused.size(), 0);
    if (stick_at_neutral_point(m_model, trial, m_refused, &m_idle)) return true;
  }
  return Dim == 3 && stick_unsupported(m_model, *m_problem.prescribed, trial, m_refused, {}, true) >= 0;
}

template <int Dim>
void SupportByFriction<Dim>::leave_cycle(const WindowSolver<Dim>& solver, const ContactState<Dim>& before,
                                         int left, ContactState<Dim>& trial) {
  ContactState<Dim> other = before;
  if (!is_lost(before) || m_cycles >= MAX_CYCLES || normals_hold(m_problem, before) ||
      !stick_at_neutral_point(m_model, other, m_refused, &m_idle))
    return;
  ++m_cycles;
  WindowSolution<Dim> solution;
  const EntryPlaces<Dim> entry = *m_problem.entry; // the test notes what it releases
  ContactState<Dim> tested = other;
  std::vector<double> severity(before.nodes.size());
  if (solver.solve(other, solution) && solver.test(solution, tested, severity) <= left) trial = other;
  *m_problem.entry = entry;
  for (std::size_t i = 0; i < m_refused.size(); ++i)
    m_refused[i] = m_refused[i] || (sticks(other.nodes[i].state) && !sticks(before.nodes[i].state));
}

template <int Dim>
void SupportByFriction<Dim>::note_refused(const ContactState<Dim>& before, const ContactState<Dim>& after) {
  for (std::size_t i = 0; i < m_refused.size(); ++i)
    m_refused[i] =
        m_refused[i] || (sticks(before.nodes[i].state) && after.nodes[i].state == NodeState::SLIDING);
}

template <int Dim> bool SupportByFriction<Dim>::is_lost(const ContactState<Dim>& state) const {
  return m_floating && none_sticks(state, m_idle);
}

template class SupportByFriction<2>;
template class SupportByFriction<3>;

} // namespace burnish
