#include "iteration/iteration.hpp"
#include "base/error.hpp"
#include "contact/coupling.hpp"
#include "contact/slip_direction.hpp"
#include "iteration/not_converged.hpp"
#include <cmath>

namespace burnish {
namespace {

constexpr int MAX_UNSOLVED = 3; // iterations in a row whose window has no solution
constexpr double NEAR =
    10; // residual over what is allowed, below which nothing goes back: near balance slopes are rounding
constexpr int MAX_HALF_WAYS = 3; // ways back in a step in space (ALGORITHMS.md 5.6)

// Iterations that a tolerance takes, over those of the default one.
double more_digits(double tolerance) {
  return std::max(1., std::log(tolerance) / std::log(IterationOptions().tolerance));
}

} // namespace

template <int Dim>
Iteration<Dim>::Iteration(const ContactModel<Dim>& model, const BodyView<Dim>& body, IterationOptions options)
    : m_model(model), m_body(body), m_options(options), m_balance(model, body, m_options) {
  require(!m_model.candidates.empty(), "contact", "number of candidate nodes", 0,
          "at least one node on the label");
  require(!m_model.tools.empty(), "contact", "number of tools", 0, "at least one tool");
  m_state.nodes.resize(m_model.candidates.size());
  m_state.q = Eigen::VectorXd::Zero(m_model.num_coordinates());
}

template <int Dim>
void Iteration<Dim>::begin(const PrescribedValues& prescribed, const ContactState<Dim>& predicted,
                           EntryPlaces<Dim> entry, bool adapt) {
  m_prescribed = prescribed;
  m_state = predicted;
  m_state.fixed = !adapt;
  m_predicted_q = predicted.q;
  m_entry = std::move(entry);
  m_adapt = adapt;
  m_number = m_unsolved = m_half_ways = 0;
  m_first_dq.resize(0);
  m_R.resize(0);
  m_way_back.begin();
  m_policy.begin();
  m_balance.set_coarse_gaps(false);
  m_failure = {};
}

template <int Dim> StepStatus Iteration<Dim>::give_up(const Failure& why) {
  m_failure = why;
  return StepStatus::FAILED;
}

template <int Dim> StepStatus Iteration<Dim>::check(Eigen::VectorXd& u, const Eigen::VectorXd& R) {
  require(R.size() == m_body.X.size(), "contact.check", "size of the force array", R.size(),
          "number of dofs");
  if (!R.allFinite()) fail("contact.check", "the force array contains NaN or Inf");
  turn_slips(m_model, R, m_state);
  m_balance.look(m_state, m_prescribed, u, R);
  const double residual = m_balance.last().residual, allowed = m_balance.allowed();
  if (!std::isfinite(residual)) return give_up(Cause::INFINITE);
  const bool consistent = !m_adapt || m_balance.last().inconsistent == 0;
  if (m_number > 0 && residual <= allowed && consistent) {
    m_balance.remember();
    return StepStatus::CONVERGED;
  }
  m_policy.look(residual, allowed);
  const double bound = more_digits(m_options.tolerance) * m_options.max_iterations;
  if (m_number >= 2 * bound || (m_number >= bound && m_policy.lags())) return give_up(not_converged());
  if (m_number >= 2 && went_too_far(u, R)) return StepStatus::BACKTRACKED;
  const bool careful = searches() && m_policy.has_grown(), came_back = Dim == 2 && m_way_back.made() > 0;
  const bool renew = careful || came_back || m_policy.grows() || m_policy.lags();
  m_policy.go_on(residual);
  m_R = R;
  return renew ? StepStatus::REFACTORIZE : StepStatus::ITERATE;
}

template <int Dim> Failure Iteration<Dim>::not_converged() const {
  const bool moved = m_way_back.start().q.size() == m_state.q.size();
  return burnish::not_converged<Dim>({m_model, m_body, m_state, m_prescribed, m_balance, m_options, m_number,
                                      m_unsolved, m_policy.last(),
                                      moved ? m_state.q - m_way_back.start().q : Eigen::VectorXd(),
                                      m_state.q - m_predicted_q, m_first_dq, m_way_back.start().u, m_R});
}

template <int Dim> void Iteration<Dim>::state_problem(WindowProblem<Dim>& problem) {
  problem.model = &m_model;
  problem.body = &m_body;
  problem.prescribed = &m_prescribed;
  problem.start = &m_state;
  problem.resting = &m_predicted_q;
  problem.R = &m_R;
  problem.entry = &m_entry;
  problem.iteration = m_number;
  problem.adapt = m_adapt;
  problem.tolerances = m_balance.state_tolerances();
}

template <int Dim> void Iteration<Dim>::leave(const Eigen::VectorXd& u, const Eigen::VectorXd& dq) {
  if (++m_number == 1) m_first_dq = dq;
  ++m_counts.iterations;
  m_way_back.leave({u, m_state.q, m_R});
}

template <int Dim> bool Iteration<Dim>::rests() {
  if (m_number > 0 || m_balance.last().residual > m_balance.allowed() || m_balance.last().inconsistent > 0)
    return false;
  for (int k = 0; k < m_model.num_coordinates(); ++k)
    if (m_prescribed.is_motion[k] && m_state.q[k] != m_prescribed.value[k]) return false;
  m_number = 1;
  return true;
}

template <int Dim> StepStatus Iteration<Dim>::solved(int contradictions) {
  m_unsolved = contradictions > 0 ? m_unsolved + 1 : 0;
  return m_unsolved < MAX_UNSOLVED ? StepStatus::ITERATE : give_up(not_converged());
}

template <int Dim> void Iteration<Dim>::arrive(const Eigen::VectorXd& u) {
  follow(m_model, m_state.q);
  find_places(u);
}

// In space what grows is often the friction of nodes whose slip turns, which the work of the body's forces does not see.
// So it is where all states are fixed, in the pieces between events.
template <int Dim> bool Iteration<Dim>::searches() const { return Dim == 2 && m_adapt; }

template <int Dim> bool Iteration<Dim>::went_too_far(Eigen::VectorXd& u, const Eigen::VectorXd& R) {
  bool moved = false;
  if (searches() && m_balance.last().residual > NEAR * m_balance.allowed())
    moved = m_way_back.go_back(u, m_state.q, R, free_of_contact(m_body, m_model.candidates, m_state),
                               m_policy.has_grown());
  else if (!searches() && m_policy.grows() && m_half_ways < MAX_HALF_WAYS)
    moved = m_way_back.go_half(u, m_state.q);
  if (!moved) return false;
  m_half_ways += !searches();
  ++m_counts.backtracks;
  arrive(u);
  return true;
}

// Places of the contact nodes: sliding ones at the foot, sticking ones where they stick. The nodes themselves stay where they are:
// what they are off their tools the next iteration closes, by the whole body (ALGORITHMS.md 5.6).
template <int Dim> void Iteration<Dim>::find_places(const Eigen::VectorXd& u) {
  const auto poses = m_model.poses(m_state.q);
  for (std::size_t i = 0; i < m_state.nodes.size(); ++i) {
    ContactNode<Dim>& node = m_state.nodes[i];
    if (!in_contact(node.state) || node.tied) continue;
    const Vector<Dim> x = m_body.position(u, m_model.candidates[i]);
    const auto& tool = *m_model.tools[node.tool];
    node.place =
        sticks(node.state) ? node.slip_origin : tool.foot(poses[node.tool], x, node.place.hint).place;
  }
  follow_ends(m_model, m_state);
}

template class Iteration<2>;
template class Iteration<3>;

} // namespace burnish
