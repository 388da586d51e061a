#include "iteration/corrector.hpp"
#include "base/cpu_time.hpp"
#include "base/error.hpp"
#include "contact/slip_direction.hpp"
#include "iteration/contact_window.hpp"
#include "solver/cholmod_solver.hpp"
#include "solver/column_factor.hpp"
#include "solver/schur_factor.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace burnish {
namespace {

constexpr double WINDOW_COVER = 0.3; // part of the window's margin that must be left, else it is chosen anew

// Whether the columns of C cost less than the cube of the window w: w^3 over nodes in contact and nodes of the body.
template <int Dim> bool columns_pay(std::size_t window, const ContactState<Dim>& state, int num_nodes) {
  constexpr double from = Dim == 2 ? 200 : 600;
  const auto touching = std::count_if(state.nodes.begin(), state.nodes.end(),
                                      [](const auto& node) { return in_contact(node.state); });
  const auto w = static_cast<double>(window);
  return w * w * w > from * static_cast<double>(touching) * num_nodes;
}

// What rounding leaves of the nodal forces in balance: that of places, times the stiffness [force]. Residuals of
// a light load on a large body come no lower.
template <int Dim> double rounding_of_forces(const NodeBlockMatrix<Dim>& K, const Eigen::VectorXd& X) {
  constexpr double roundings = 4; // of a place and of the sums that it enters
  double stiffness = 0;
  for (int node = 0; node < K.num_nodes; ++node) {
    const double* block = K.block(K.find(node, node));
    for (int c = 0; c < Dim; ++c) stiffness = std::max(stiffness, std::abs(block[c * Dim + c]));
  }
  return roundings * std::numeric_limits<double>::epsilon() * stiffness * X.cwiseAbs().maxCoeff();
}

} // namespace

template <int Dim>
Corrector<Dim>::Corrector(Iteration<Dim>& iteration)
    : m_iteration(iteration), m_floating(!constrains_rigid_motions(iteration.body())),
      m_mixer(iteration.options().anderson_memory) {}

template <int Dim> void Corrector<Dim>::begin(bool keep_factor) {
  m_keep_factor = keep_factor;
  m_indefinite = false;
  m_mixer = AndersonMixer(m_iteration.options().anderson_memory);
  if (m_has_factor) take_flexibility(); // nothing of the last step but its state
  if (m_has_factor && keep_factor) m_iteration.state().slip_stiffness = m_tangent->slip_stiffness;
}

template <int Dim> void Corrector<Dim>::restore(const FactorMemory<Dim>& memory) {
  m_window = memory.window;
  m_has_factor = memory.tangent != nullptr;
  if (m_has_factor) m_tangent = memory.tangent;
  m_age = memory.age;
  if (m_has_factor && !m_tangent->solver)
    m_tangent->factorize_again(m_iteration.model(), m_iteration.body(), make_solver(m_tangent->by_columns));
}

template <int Dim> void Corrector<Dim>::set_solver(std::function<std::unique_ptr<BodySolver<Dim>>()> make) {
  m_make_solver = std::move(make);
  m_tangent = nullptr;
  m_has_factor = false;
}

template <int Dim> void Corrector<Dim>::take_flexibility() {
  const BodySolver<Dim>* solver = m_tangent->solver.get();
  ActivePart::Parts parts;
  const auto timed = [this](const auto& solve) {
    double seconds = 0;
    auto result = [&] {
      const CpuTimer timer(seconds);
      return solve();
    }();
    m_iteration.counts().solve_seconds += seconds;
    m_iteration.counts().condensation_seconds -= seconds; // which are counted there, too
    return result;
  };
  if (solver->in_parts()) {
    parts.places = [timed, solver](const std::vector<int>& components) {
      return timed([&] { return solver->complete_flexibility(components); });
    };
    parts.times = [timed, solver](const Eigen::VectorXd& p) {
      return timed([&] { return solver->displacement_under(p); });
    };
  }
  m_flexibility.set(m_tangent->flexibility, solver->symmetric(), std::move(parts));
}

// A saved state keeps its factor.
template <int Dim> void Corrector<Dim>::make_tangent(int num_nodes) {
  const bool by_columns = columns_pay<Dim>(m_window.size(), m_iteration.state(), num_nodes);
  if (m_tangent && m_tangent.use_count() == 1 && (m_make_solver || by_columns == m_tangent->by_columns))
    return;
  m_tangent = std::make_shared<FactoredTangent<Dim>>();
  m_tangent->by_columns = by_columns;
  m_tangent->solver = make_solver(by_columns);
}

template <int Dim> std::unique_ptr<BodySolver<Dim>> Corrector<Dim>::make_solver(bool by_columns) const {
  if (m_make_solver) return m_make_solver();
  if (by_columns) return std::make_unique<ColumnFactor<Dim>>(std::make_unique<CholmodSolver>(Dim));
  return std::make_unique<SchurFactor<Dim>>();
}

template <int Dim> bool Corrector<Dim>::serves(const Eigen::VectorXd& u) const {
  if (!m_has_factor || (m_iteration.number() == 0 && !m_keep_factor)) return false;
  const Iteration<Dim>& it = m_iteration;
  const std::vector<int> needed =
      near_contact(it.model(), it.body(), it.state(), u, WINDOW_COVER, it.options());
  return std::includes(m_window.begin(), m_window.end(), needed.begin(), needed.end());
}

template <int Dim> std::vector<int> Corrector<Dim>::new_window(const Eigen::VectorXd& u) const {
  const Iteration<Dim>& it = m_iteration;
  std::vector<int> window = near_contact(it.model(), it.body(), it.state(), u, 1, it.options());
  if (!m_floating) return window;
  std::vector<int> both;
  const std::vector<int> far = far_candidates(it.model(), it.body());
  std::set_union(window.begin(), window.end(), far.begin(), far.end(), std::back_inserter(both));
  return both;
}

template <int Dim> FactorStatus Corrector<Dim>::factorize(NodeBlockMatrix<Dim> K, const Eigen::VectorXd& u) {
  Iteration<Dim>& it = m_iteration;
  require(K.size() == it.body().X.size(), "contact.factorize", "size of K", K.size(), "number of dofs");
  const std::vector<int> needed =
      near_contact(it.model(), it.body(), it.state(), u, WINDOW_COVER, it.options());
  if (m_window.empty() || !std::includes(m_window.begin(), m_window.end(), needed.begin(), needed.end()))
    m_window = new_window(u);
  it.balance().memory().rounding = rounding_of_forces(K, it.body().X);
  m_age = 0;
  forget_mixing();
  make_tangent(K.num_nodes);
  m_tangent->window = m_window;
  m_tangent->matrix = m_keeps_matrices ? K : NodeBlockMatrix<Dim>();
  m_tangent->slip_stiffness = it.state().slip_stiffness = slip_stiffness(it.model(), K);
  IterationCounts& counts = it.counts();
  FactorStatus status;
  {
    const CpuTimer timer(counts.factorization_seconds);
    const int analyses = m_tangent->solver->analyses();
    const bool held = !m_floating && it.policy().desperate(); // K may be needed again
    status = m_tangent->factorize(it.model(), it.body(), it.state(),
                                  held ? NodeBlockMatrix<Dim>(K) : std::move(K), m_floating);
    if (m_indefinite && status == FactorStatus::OK) status = FactorStatus::NOT_POSITIVE_DEFINITE;
    m_has_factor = status == FactorStatus::OK;
    if (!m_has_factor && held) m_has_factor = factorize_held(K, u) == FactorStatus::OK;
    counts.analyses += m_tangent->solver->analyses() - analyses;
  }
  ++counts.factorizations;
  counts.factor_entries = static_cast<long>(m_tangent->solver->factor_entries());
  it.policy().factored(m_has_factor);
  if (!m_has_factor) {
    const bool singular = status == FactorStatus::SINGULAR;
    if (it.policy().blend_exhausted()) it.give_up(singular ? Cause::NOT_FACTORED : Cause::UNSTABLE);
    return status;
  }
  if (!m_tangent->flexibility || m_tangent->added_stiffness.size() == 0 || m_floating) {
    const CpuTimer timer(counts.condensation_seconds);
    m_tangent->condense();
    take_flexibility();
  }
  return FactorStatus::OK;
}

// A body that is not stable alone may be so between its tools: the factor is one of the body held at its contact nodes,
// and the dense block, which lets go of them again, tells (METHOD.md 5.6).
template <int Dim>
FactorStatus Corrector<Dim>::factorize_held(const NodeBlockMatrix<Dim>& K, const Eigen::VectorXd& u) {
  WindowProblem<Dim> states;
  m_iteration.state_problem(states);
  const Eigen::VectorXd& R = *states.R;
  if (R.size() != u.size()) return FactorStatus::NOT_POSITIVE_DEFINITE;
  const FactorStatus status =
      m_tangent->factorize(m_iteration.model(), m_iteration.body(), m_iteration.state(), K, true);
  if (status != FactorStatus::OK) return status;
  m_tangent->condense();
  take_flexibility();
  WindowProblem<Dim> problem = window_problem(u, R, m_tangent->solver->sweep(-R));
  problem.adapt = false;
  return solve_window(problem).unstable ? FactorStatus::NOT_POSITIVE_DEFINITE : FactorStatus::OK;
}

template <int Dim> void Corrector<Dim>::measure(const NodeBlockMatrix<Dim>& K) {
  m_iteration.balance().memory().rounding = rounding_of_forces(K, m_iteration.body().X);
  drop_factor();
}

template <int Dim> double Corrector<Dim>::compliance() const {
  if (!m_has_factor || !m_tangent->flexibility || m_tangent->flexibility->size() == 0) return 0;
  return m_tangent->flexibility->diagonal().maxCoeff();
}

template <int Dim>
WindowProblem<Dim> Corrector<Dim>::window_problem(const Eigen::VectorXd& u, const Eigen::VectorXd& R,
                                                  const SweptLoad& load) {
  WindowProblem<Dim> problem;
  m_iteration.state_problem(problem);
  problem.R = &R;
  problem.u = &u;
  problem.window = &m_tangent->window;
  problem.flexibility = &m_flexibility;
  problem.added_stiffness = m_tangent->added_stiffness;
  problem.free_increment = m_tangent->solver->candidate_displacement(load);
  problem.terms = m_iteration.options().terms;
  problem.test_stability = !m_floating && m_tangent->added_stiffness.size() > 0;
  if (!problem.test_stability) // stability needs the derivative
    problem.friction_tangent = m_iteration.options().friction_tangent;
  return problem;
}

template <int Dim> SweptLoad Corrector<Dim>::sweep(const Eigen::VectorXd& b) {
  const CpuTimer timer(m_iteration.counts().solve_seconds);
  return m_tangent->solver->sweep(b);
}

template <int Dim>
Eigen::VectorXd Corrector<Dim>::displacement(const SweptLoad& load, const Eigen::VectorXd& p) {
  const CpuTimer timer(m_iteration.counts().solve_seconds);
  ++m_iteration.counts().solves;
  return m_tangent->solver->displacement(load, p);
}

// With the tools at rest it would be so only for want of supports.
template <int Dim>
Failure Corrector<Dim>::singular(const WindowSolution<Dim>& solution, const WindowProblem<Dim>& problem) {
  PrescribedValues resting = m_iteration.prescribed();
  resting.is_motion.assign(resting.is_motion.size(), 1);
  resting.value = m_iteration.state().q;
  WindowProblem<Dim> at_rest = problem;
  at_rest.prescribed = &resting;
  const bool floats = solve_window(at_rest).singular;
  if (floats && m_floating) return Cause::NOT_HELD;
  if (!floats && solution.weakest_coordinate < 0) return Cause::TIPS_OVER;
  Failure failure(solution.weakest_coordinate >= 0 ? Cause::UNRESISTED : Cause::SINGULAR);
  failure.coordinate = solution.weakest_coordinate;
  failure.flag = m_floating;
  return failure;
}

template <int Dim> StepStatus Corrector<Dim>::correct(Eigen::VectorXd& u, const Eigen::VectorXd& R) {
  if (!m_has_factor) fail("contact.correct", "no factor: call factorize first");
  const SweptLoad load = sweep(-R);
  WindowSolution<Dim> solution;
  {
    const CpuTimer timer(m_iteration.counts().condensation_seconds);
    const WindowProblem<Dim> problem = window_problem(u, R, load);
    solution = solve_window(problem);
    if (solution.stopped) return StepStatus::ITERATE; // with the iterate as it is: the run ends
    if (solution.indefinite && !m_floating && !m_indefinite && m_tangent->solver->symmetric()) {
      m_indefinite = true;
      m_has_factor = false;
      return StepStatus::REFACTORIZE;
    }
    if (solution.singular && m_floating && m_iteration.rests()) return StepStatus::ITERATE;
    if (solution.singular) return m_iteration.give_up(singular(solution, problem));
  }
  if (solution.unstable) return m_iteration.give_up(Cause::UNSTABLE);
  if (m_iteration.solved(solution.left) == StepStatus::FAILED) return StepStatus::FAILED;
  const Eigen::VectorXd b =
      scatter_window(m_iteration.model(), m_tangent->window, solution.load, R.size()) - R;
  const Eigen::VectorXd du = displacement(load, solution.load);
  ContactState<Dim>& state = m_iteration.state();
  const Eigen::Index n = u.size(), nq = state.q.size();
  Eigen::VectorXd z(n + nq), g(n + nq);
  z << u, state.q;
  g << du, solution.state.q - state.q;
  m_iteration.leave(u, g.tail(nq));
  const Eigen::VectorXd step = m_mixer.mix(z, g, b);
  state.nodes = std::move(solution.state.nodes);
  u += step.head(n);
  state.q += step.tail(nq);
  m_iteration.arrive(u);
  return StepStatus::ITERATE;
}

template class Corrector<2>;
template class Corrector<3>;

} // namespace burnish
