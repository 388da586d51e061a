#include "stepping/corrector.hpp"
#include "base/cpu_time.hpp"
#include "base/error.hpp"
#include "contact/coupling.hpp"
#include "contact/slip_motion.hpp"
#include "contact/tool_support.hpp"
#include "stepping/contact_window.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr const char* NOT_HELD = "the workpiece is not held: neither supports (fixed=) nor the tools that "
                                 "touch it take all its rigid motions";
constexpr const char* TIPS_OVER =
    "nothing resists a motion of the tools under force control: a tool tips over or rolls away";

// Iterations that a tolerance takes, over those of the default one.
double more_digits(double tolerance) {
  return std::max(1., std::log(tolerance) / std::log(StepOptions().tolerance));
}

} // namespace

template <int Dim>
Corrector<Dim>::Corrector(const ContactModel<Dim>& model, const BodyView<Dim>& body, StepOptions options)
    : m_model(model), m_body(body), m_options(options), m_floating(!constrains_rigid_motions(body)),
      m_mixer(options.anderson_memory) {
  require(!m_model.candidates.empty(), "contact", "number of candidate nodes", 0,
          "at least one node on the label");
  require(!m_model.tools.empty(), "contact", "number of tools", 0, "at least one tool");
  m_state.nodes.resize(m_model.candidates.size());
  m_state.q = Eigen::VectorXd::Zero(m_model.num_coordinates());
}

template <int Dim>
void Corrector<Dim>::begin(const PrescribedValues& prescribed, const ContactState<Dim>& predicted,
                           std::vector<ContactNode<Dim>> entry, bool adapt, bool keep_factor) {
  m_prescribed = prescribed;
  m_keep_factor = keep_factor;
  m_state = predicted;
  m_entry = {std::move(entry), std::vector<int>(m_state.nodes.size(), 0)};
  m_adapt = adapt;
  m_iteration = m_backtracks = m_step_factorizations = m_indefinite = 0;
  m_last_residual = -1;
  m_first_dq.resize(0);
  m_R.resize(0);
  m_condensed = m_again = false;
  m_passes = m_falls = 0;
  m_refused.assign(m_state.nodes.size(), 0);
  m_mixer = AndersonMixer(m_options.anderson_memory);
  m_rate = ConvergenceRate(m_options.rate_window, m_options.rate_bound);
  m_fresh.assign(m_state.nodes.size(), 0);
  m_reason.clear();
  if (m_has_factor) m_flexibility.set(m_tangent->flexibility); // nothing of the last step but its state
}

template <int Dim> CorrectorMemory<Dim> Corrector<Dim>::memory() const {
  return {m_load_scale, m_tool_load, m_rounding, m_window, m_has_factor ? m_tangent : nullptr, m_factor_age};
}

template <int Dim> void Corrector<Dim>::restore(const CorrectorMemory<Dim>& memory) {
  m_load_scale = memory.load_scale;
  m_tool_load = memory.tool_load;
  m_rounding = memory.rounding;
  m_window = memory.window;
  m_has_factor = memory.tangent != nullptr;
  if (m_has_factor) m_tangent = memory.tangent;
  m_factor_age = memory.factor_age;
}

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

template <int Dim> StepStatus Corrector<Dim>::check(Eigen::VectorXd& u, const Eigen::VectorXd& R) {
  require(R.size() == m_body.X.size(), "contact.check", "size of the force array", R.size(),
          "number of dofs");
  if (!R.allFinite()) fail("contact.check", "the force array contains NaN or Inf");
  if (m_again) return StepStatus::ITERATE; // states have changed, nothing has moved
  const double scale = balance_at(u, R);
  const double res = m_balance.residual;
  if (!std::isfinite(res)) return give_up("the residual is not finite");
  const bool consistent = !m_adapt || m_balance.inconsistent == 0;
  if (m_iteration > 0 && res <= allowed(scale) && consistent) {
    m_load_scale = scale;
    m_tool_load =
        m_tool_load.size() > 0 ? m_tool_load.cwiseMax(m_balance.tool_load).eval() : m_balance.tool_load;
    return StepStatus::CONVERGED;
  }
  const bool lags = !m_condensed && m_rate.slow(res, allowed(scale)); // condensed: every tangent is new
  const double bound = more_digits(m_options.tolerance) * m_options.max_iterations;
  if (m_iteration >= 2 * bound || (m_iteration >= bound && lags)) return give_up(reason_of_failure(scale));
  const bool slow = m_last_residual >= 0 && res > m_options.slow * m_last_residual;
  if (slow && m_iteration >= 2 && m_backtracks < m_options.max_backtracks && m_u_before.size() == u.size())
    return backtrack(u);
  if (m_condensed) choose_blend(res);
  if (lags && m_rate.fall() < m_options.rate_fall) m_step_factorizations = 0; // it converges: nothing cycles
  m_last_residual = res;
  m_R = R;
  const bool fresh = m_iteration == 0 && !m_keep_factor;
  const bool renew = !m_has_factor || fresh || (slow && res > allowed(scale)) || lags || !window_covers(u);
  return renew ? StepStatus::REFACTORIZE : StepStatus::ITERATE;
}

template <int Dim> bool Corrector<Dim>::window_covers(const Eigen::VectorXd& u) const {
  const std::vector<int> needed =
      near_contact(m_model, m_body, m_state, u, m_options.window_cover * m_options.window_width,
                   m_options.window_cover * m_options.window_nodes, m_options);
  return std::includes(m_window.begin(), m_window.end(), needed.begin(), needed.end());
}

template <int Dim> ActiveSetOptions Corrector<Dim>::active_set_options() const {
  const double gap = m_options.state_gap * m_options.gap_tolerance * m_body.spacing;
  ActiveSetOptions options;
  options.tolerance.force = m_options.state_force * allowed(std::max(m_load_scale, m_balance.load));
  options.tool_force = m_options.state_force * tool_tolerance();
  options.tolerance.slip = m_options.state_slip * gap;
  options.gap = gap;
  options.max_passes = m_options.max_state_passes;
  options.max_neutral_trials = m_options.max_neutral_trials;
  return options;
}

template <int Dim>
WindowProblem<Dim> Corrector<Dim>::window_problem(const Eigen::VectorXd& u, const Eigen::VectorXd& R,
                                                  const SweptLoad& load) {
  WindowProblem<Dim> problem;
  problem.window = &m_tangent->window;
  problem.flexibility = &m_flexibility;
  problem.added_stiffness = m_tangent->added_stiffness;
  problem.free_increment = m_tangent->solver->candidate_displacement(load);
  problem.u = &u;
  problem.R = &R;
  problem.entry = &m_entry;
  problem.adapt = m_adapt;
  problem.options = active_set_options();
  problem.terms = m_options.terms;
  problem.test_stability = !m_floating && m_tangent->added_stiffness.size() > 0;
  if (!problem.test_stability)
    problem.friction_tangent = m_options.friction_tangent; // stability needs the derivative
  return problem;
}

template <int Dim> SweptLoad Corrector<Dim>::sweep(const Eigen::VectorXd& b) {
  const CpuTimer timer(m_counts.solve_seconds);
  return m_tangent->solver->sweep(b);
}

template <int Dim>
Eigen::VectorXd Corrector<Dim>::displacement(const SweptLoad& load, const Eigen::VectorXd& p) {
  const CpuTimer timer(m_counts.solve_seconds);
  ++m_counts.solves;
  return m_tangent->solver->displacement(load, p);
}

template <int Dim> StepStatus Corrector<Dim>::correct(Eigen::VectorXd& u, const Eigen::VectorXd& R) {
  if (!m_has_factor) fail("contact.correct", "no factor: call factorize first");
  ++m_iteration;
  ++m_counts.iterations;
  const SweptLoad load = sweep(-R);
  WindowSolution<Dim> solution;
  {
    const CpuTimer timer(m_counts.condensation_seconds);
    solution = solve_window(m_model, m_body, m_prescribed, m_state, window_problem(u, R, load));
  }
  if (solution.singular) { // with the tools at rest it would be so only for want of supports
    PrescribedValues resting = m_prescribed;
    resting.is_motion.assign(resting.is_motion.size(), 1);
    resting.value = m_state.q;
    const bool floats = solve_window(m_model, m_body, resting, m_state, window_problem(u, R, load)).singular;
    if (floats && m_floating) return give_up(NOT_HELD);
    if (!floats && solution.weakest_coordinate < 0) return give_up(TIPS_OVER);
    return give_up(singular_reason(solution));
  }
  if (solution.unstable) return give_up(UNSTABLE);
  const Eigen::VectorXd b = scatter_window(m_model, m_tangent->window, solution.load, R.size()) - R;
  const Eigen::VectorXd du = displacement(load, solution.load);
  const Eigen::Index n = u.size(), nq = m_state.q.size();
  Eigen::VectorXd z(n + nq), g(n + nq);
  z << u, m_state.q;
  g << du, solution.state.q - m_state.q;
  m_u_before = u;
  m_q_before = m_state.q;
  if (m_iteration == 1) m_first_dq = solution.state.q - m_state.q;
  const Eigen::VectorXd step = m_mixer.mix(z, g, b);
  m_fresh = solution.fresh;
  m_state.nodes = solution.state.nodes;
  u += step.head(n);
  m_state.q += step.tail(nq);
  follow(m_model, m_state.q);
  project(u, m_mixer.mixed());
  return StepStatus::ITERATE;
}

// Puts the contact nodes onto their tools: sliding nodes at the projection, sticking ones at their place.
// Nodes that came into contact in this iteration keep an interpolated position (ALGORITHMS.md 5.6).
template <int Dim> void Corrector<Dim>::project(Eigen::VectorXd& u, bool keep_fresh) {
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
  for (std::size_t i = 0; i < m_state.nodes.size(); ++i) {
    const ContactNode<Dim>& node = m_state.nodes[i];
    if (!in_contact(node.state) || (keep_fresh && m_fresh[i])) continue;
    const int mesh_node = m_model.candidates[i];
    const Vector<Dim> x = m_body.position(u, mesh_node);
    const auto& tool = *m_model.tools[node.tool];
    u.template segment<Dim>(Dim * mesh_node) +=
        offset_to(m_model, static_cast<int>(i), tool.point(poses[node.tool], node.place), x);
  }
}

template class Corrector<2>;
template class Corrector<3>;

} // namespace burnish
