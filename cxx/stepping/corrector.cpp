#include "stepping/corrector.hpp"
#include "base/cpu_time.hpp"
#include "base/error.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace burnish {
namespace {

// What rounding leaves of the nodal forces in balance: that of places, times the stiffness [force]. Residuals of
// a light load on a large body come no lower.
template <int Dim> double rounding_of_forces(const NodeBlockMatrix<Dim>& K, const Eigen::VectorXd& X) {
  double stiffness = 0;
  for (int node = 0; node < K.num_nodes; ++node) {
    const double* block = K.block(K.find(node, node));
    for (int c = 0; c < Dim; ++c) stiffness = std::max(stiffness, std::abs(block[c * Dim + c]));
  }
  return 4 * std::numeric_limits<double>::epsilon() * stiffness * X.cwiseAbs().maxCoeff();
}

} // namespace

template <int Dim>
Corrector<Dim>::Corrector(ContactModel<Dim> model, Eigen::VectorXd X, std::vector<char> fixed,
                          StepOptions options, bool axisymmetric)
    : m_model(std::move(model)), m_options(options), m_mixer(options.anderson_memory) {
  require(!m_model.candidates.empty(), "contact", "number of candidate nodes", 0,
          "at least one node on the label");
  require(!m_model.tools.empty(), "contact", "number of tools", 0, "at least one tool");
  require(X.size() == static_cast<Eigen::Index>(fixed.size()), "contact", "number of fixed flags",
          fixed.size(), "one per degree of freedom");
  if (!X.allFinite()) fail("contact", "a node coordinate is not finite");
  m_body.X = std::move(X);
  m_body.fixed = std::move(fixed);
  m_body.axisymmetric = axisymmetric;
  m_body.spacing = candidate_spacing(m_body.X, Dim, m_model.candidates);
  if (m_body.spacing == 0) m_body.spacing = m_model.tools[0]->profile().length_scale() * 1e-2;
  m_state.nodes.resize(m_model.candidates.size());
  m_state.q = Eigen::VectorXd::Zero(m_model.num_coordinates());
  m_floating = !holds_rigid_motions(m_body);
}

template <int Dim>
void Corrector<Dim>::begin(const Program& program, const ContactState<Dim>& predicted,
                           std::vector<ContactNode<Dim>> entry, bool adapt, bool keep_factor) {
  m_program = program;
  m_keep_factor = keep_factor;
  m_state = predicted;
  m_entry = std::move(entry);
  m_adapt = adapt;
  m_iteration = m_backtracks = m_step_factorizations = m_indefinite = 0;
  m_last_residual = m_best_residual = -1;
  m_mixer = AndersonMixer(m_options.anderson_memory);
  m_fresh.assign(m_state.nodes.size(), 0);
  m_releases.assign(m_state.nodes.size(), 0);
  m_reason.clear();
}

// A billionth of what rounding leaves is no load at all: a tool under zero force.
template <int Dim> double Corrector<Dim>::allowed(double scale) const {
  const double capped = std::min(m_rounding, StepOptions().tolerance * scale);
  return std::max({m_options.tolerance * scale, capped, 1e-9 * m_rounding});
}

// Sets m_balance; returns the load scale, in which the load of this state counts in its own tolerance.
template <int Dim> double Corrector<Dim>::balance_at(const Eigen::VectorXd& u, const Eigen::VectorXd& R) {
  const double h = m_body.spacing;
  double scale = m_load_scale;
  for (int pass = 0; pass < 2; ++pass) {
    m_balance = balance(m_model, m_body, m_state, m_program, u, R, allowed(scale),
                        m_options.gap_tolerance * h, m_options.offset_tolerance * h);
    if (m_balance.load <= scale) break;
    scale = m_balance.load;
  }
  return scale;
}

template <int Dim> void Corrector<Dim>::measure(const Eigen::VectorXd& u, const Eigen::VectorXd& R) {
  m_load_scale = balance_at(u, R);
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
         << ": too little to hold a coordinate under force";
  } else {
    text << ": the forces balance, but states cycle";
  }
  return text.str();
}

template <int Dim> StepStatus Corrector<Dim>::check(Eigen::VectorXd& u, const Eigen::VectorXd& R) {
  require(R.size() == m_body.X.size(), "contact.check", "size of the force array", R.size(),
          "number of dofs");
  if (!R.allFinite()) fail("contact.check", "the force array holds NaN or Inf");
  const double scale = balance_at(u, R);
  const double res = m_balance.residual;
  if (!std::isfinite(res)) {
    m_reason = "the residual is not finite";
    return StepStatus::FAILED;
  }
  const bool consistent = !m_adapt || m_balance.inconsistent == 0;
  if (m_iteration > 0 && res <= allowed(scale) && consistent) {
    m_load_scale = scale;
    return StepStatus::CONVERGED;
  }
  if (m_iteration >= m_options.max_iterations) {
    m_reason = reason_of_failure(scale);
    return StepStatus::FAILED;
  }
  const bool slow = m_last_residual >= 0 && res > m_options.slow * m_last_residual;
  if (slow && m_iteration >= 2 && m_backtracks < m_options.max_backtracks && m_u_before.size() == u.size()) {
    ++m_backtracks;
    ++m_counts.backtracks;
    u = 0.5 * (u + m_u_before);
    m_state.q = 0.5 * (m_state.q + m_q_before);
    project(u, true);
    m_u_before.resize(0);
    m_mixer.clear();
    return StepStatus::BACKTRACKED;
  }
  m_last_residual = res;
  if (m_best_residual < 0 || res < m_best_residual) m_best_residual = res;
  const bool covered = window_covers(u);
  const bool fresh = m_iteration == 0 && !m_keep_factor;
  return !m_has_factor || fresh || (slow && res > allowed(scale)) || !covered ? StepStatus::REFACTORIZE
                                                                              : StepStatus::ITERATE;
}

template <int Dim>
FactorStatus Corrector<Dim>::factorize(const NodeBlockMatrix<Dim>& K, const Eigen::VectorXd& u) {
  require(K.size() == m_body.X.size(), "contact.factorize", "size of K", K.size(), "number of dofs");
  if (!window_covers(u) || m_window.empty()) choose_window(u);
  m_rounding = rounding_of_forces(K, m_body.X);
  std::vector<int> nodes;
  for (const int i : m_window) nodes.push_back(m_model.candidates[i]);
  {
    const CpuTimer timer(m_counts.factorization_seconds);
    m_factor.analyze(K, m_body.fixed, nodes);
    m_has_factor = m_factor.factorize(m_floating ? shifted(K) : K) == FactorStatus::OK;
  }
  ++m_counts.factorizations;
  m_counts.analyses = m_factor.analyses();
  m_mixer.clear();
  if (!m_has_factor) {
    if (++m_indefinite > 3)
      m_reason = "the tangent is not positive definite: loss of stability or limit load";
    return FactorStatus::NOT_POSITIVE_DEFINITE;
  }
  m_indefinite = 0;
  ++m_step_factorizations;
  const CpuTimer timer(m_counts.condensation_seconds);
  m_flexibility = m_factor.candidate_flexibility();
  const double mean = m_flexibility.diagonal().mean();
  for (Eigen::Index d = 0; d < m_flexibility.rows(); ++d) // a dof held by the script gives way by nothing
    if (m_flexibility(d, d) == 0) m_flexibility(d, d) = 1e-9 * mean;
  return FactorStatus::OK;
}

template <int Dim> double Corrector<Dim>::elastic_blend() const {
  constexpr double by_factorization[] = {0, 0.2, 0.2, 0.4}, by_failure[] = {0, 0.05, 0.2, 0.8};
  return std::max(by_factorization[std::min(m_step_factorizations, 3)],
                  by_failure[std::min(m_indefinite, 3)]);
}

template <int Dim>
WindowProblem<Dim> Corrector<Dim>::window_problem(const Eigen::VectorXd& u, const Eigen::VectorXd& R,
                                                  const Eigen::VectorXd& free_increment) {
  WindowProblem<Dim> problem;
  problem.window = &m_window;
  problem.flexibility = &m_flexibility;
  if (m_floating) problem.shift = m_shift;
  problem.free_increment = on_window(free_increment);
  problem.u = &u;
  problem.R = &R;
  problem.entry = &m_entry;
  problem.releases = &m_releases;
  problem.force_tolerance = 0.1 * allowed(std::max(m_load_scale, m_balance.load));
  problem.gap_tolerance = 0.5 * m_options.gap_tolerance * m_body.spacing;
  problem.adapt = m_adapt;
  problem.max_passes = m_options.max_state_passes;
  problem.terms = m_options.terms;
  return problem;
}

template <int Dim> Eigen::VectorXd Corrector<Dim>::solve(const Eigen::VectorXd& b) {
  const CpuTimer timer(m_counts.solve_seconds);
  ++m_counts.solves;
  return m_factor.solve(b);
}

template <int Dim> StepStatus Corrector<Dim>::correct(Eigen::VectorXd& u, const Eigen::VectorXd& R) {
  if (!m_has_factor) fail("contact.correct", "no factor: call factorize first");
  ++m_iteration;
  ++m_counts.iterations;
  const Eigen::VectorXd u0 = solve(-R);
  WindowSolution<Dim> solution;
  {
    const CpuTimer timer(m_counts.condensation_seconds);
    solution = solve_window(m_model, m_body, m_program, m_state, window_problem(u, R, u0));
  }
  if (solution.singular) {
    m_reason = m_floating ? "singular contact block: neither supports nor tools hold the workpiece"
                          : "singular contact block";
    if (solution.weakest_coordinate >= 0) {
      std::ostringstream text;
      text << "nothing resists " << m_model.coordinate(solution.weakest_coordinate) << " under force control";
      m_reason = text.str();
    }
    return StepStatus::FAILED;
  }
  const Eigen::VectorXd b = scatter_window(solution.load) - R;
  const Eigen::VectorXd du = solve(b);
  const Eigen::Index n = u.size(), nq = m_state.q.size();
  Eigen::VectorXd z(n + nq), g(n + nq);
  z << u, m_state.q;
  g << du, solution.state.q - m_state.q;
  m_u_before = u;
  m_q_before = m_state.q;
  const Eigen::VectorXd step = m_mixer.mix(z, g, b);
  m_fresh = solution.fresh;
  m_state.nodes = solution.state.nodes;
  u += step.head(n);
  m_state.q += step.tail(nq);
  project(u, m_mixer.mixed());
  return StepStatus::ITERATE;
}

// Puts the contact nodes onto their tools: sliding nodes at the projection, sticking ones at their place.
// Nodes that came into contact in this iteration keep an interpolated position (algorithms.md 5.6).
template <int Dim> void Corrector<Dim>::project(Eigen::VectorXd& u, bool keep_fresh) {
  const auto poses = m_model.poses(m_state.q);
  for (std::size_t i = 0; i < m_state.nodes.size(); ++i) {
    ContactNode<Dim>& node = m_state.nodes[i];
    if (!in_contact(node.state)) continue;
    const int mesh_node = m_model.candidates[i];
    const Vector<Dim> x = m_body.position(u, mesh_node);
    const auto& tool = *m_model.tools[node.tool];
    node.s = holds(node.state) ? node.s_ref : tool.closest_point(poses[node.tool], x, node.s).s;
    if (keep_fresh && m_fresh[i]) continue;
    u.template segment<Dim>(Dim * mesh_node) +=
        offset_to(m_model, static_cast<int>(i), tool.surface(poses[node.tool], node.s), x);
  }
}

template class Corrector<2>;

} // namespace burnish
