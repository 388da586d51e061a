#include "run/condensed_step.hpp"
#include "base/cpu_time.hpp"
#include "base/error.hpp"
#include "base/stop_request.hpp"
#include "contact/idle_combinations.hpp"
#include "contact/slip_direction.hpp"
#include "contact/slip_motion.hpp"
#include "solver/fill_ordering.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {

template <int Dim> void StepUnderWay<Dim>::require_begun(const char* where) const {
  if (stage == Stage::NONE) fail(where, "no step is under way, call begin first");
}
template <int Dim> void StepUnderWay<Dim>::require_checked(const char* where) const {
  require_begun(where);
  if (stage != Stage::CHECKED) fail(where, "this step has not been checked, call check first");
}

template <int Dim>
CondensedStep<Dim>::CondensedStep(Iteration<Dim>& iteration, BodyLoads<Dim>& loads, StepUnderWay<Dim>& step,
                                  const ContactState<Dim>& start)
    : m_iteration(iteration), m_loads(loads), m_step(step), m_start(start), m_way(iteration),
      m_condensation(iteration.model(), iteration.body()) {}

template <int Dim> void CondensedStep<Dim>::begin() {
  m_way.begin();
  m_solver = UnsymmetricSolver();
}

template <int Dim>
const CondensedSystem& CondensedStep<Dim>::condense(const NodeBlockMatrix<Dim>& K, const Eigen::VectorXd& u,
                                                    const Eigen::VectorXd& R, GeometricTerms terms,
                                                    RightHandSide right, bool half) {
  m_step.require_begun("contact.condense");
  const Eigen::Index dofs = m_iteration.body().X.size();
  require(u.size() == dofs && R.size() == dofs, "contact.condense", "size of the arrays", R.size(),
          "number of dofs");
  if (!R.allFinite()) fail("contact.condense", "the force array contains NaN or Inf");
  ++m_iteration.counts().condensations;
  const ContactModel<Dim>& model = m_iteration.model();
  ContactState<Dim>& state = m_iteration.state();
  NodeBlockMatrix<Dim> copy;
  const NodeBlockMatrix<Dim>& sprung = K.size() == dofs ? m_loads.with_springs(K, m_step.end(), copy) : K;
  // one number for all iterations of a step: the directions of slip have been taken with it. K of another size is refused below
  const bool first = m_iteration.number() == 0 || state.slip_stiffness == 0;
  if (first && K.size() == dofs) state.slip_stiffness = slip_stiffness(model, sprung);
  m_way.prepare();
  WindowProblem<Dim> problem;
  m_iteration.state_problem(problem);
  const PrescribedValues end = with_idle_given(model, m_step.prescribed, state, *problem.resting);
  return m_condensation.condense({sprung, state, end, m_step.prescribed_start, u,
                                  m_loads.residual(u, m_step.end(), R), terms, right, half,
                                  m_iteration.options().friction_tangent, m_way.by_friction()});
}

template <int Dim> double CondensedStep<Dim>::expand(const Eigen::VectorXd& z, Eigen::VectorXd& u) {
  m_step.require_begun("contact.expand");
  require(u.size() == m_iteration.body().X.size(), "contact.expand", "size of u", u.size(), "number of dofs");
  const auto increment = m_condensation.expand(z);
  if (m_step.stepping == Stepping::RATES) {
    u += increment.du;
    move_by(m_iteration.model(), increment, m_iteration.state());
  } else {
    m_way.advance(increment, u);
  }
  return increment.du.cwiseAbs().maxCoeff();
}

template <int Dim> bool CondensedStep<Dim>::pays(const std::function<NodeBlockMatrix<Dim>()>& pattern) {
  constexpr double LEAST = 300; // nodes in contact: of fewer the fill is not counted
  constexpr double FROM =
      Dim == 2 ? 200 : 80;   // their cube over the numbers in a factor of K, where both cost the same
  constexpr double ON = 0.5; // it goes on with that part of them
  const bool under_way = m_iteration.policy().condensed();
  if (m_iteration.number() > 0 && !under_way) return false;
  const auto& nodes = m_iteration.state().nodes;
  const auto touching = static_cast<double>(
      std::count_if(nodes.begin(), nodes.end(), [](const auto& node) { return in_contact(node.state); }));
  const double from = under_way ? ON : 1;
  if (touching < from * LEAST) return false;
  if (m_fill == 0) {
    const NodeBlockMatrix<Dim> K = pattern();
    m_fill = Dim * Dim * factor_fill({K.row_start, K.col}, usual_ordering<Dim>);
  }
  return std::pow(touching / from, 3) > FROM * m_fill;
}

template <int Dim>
bool CondensedStep<Dim>::iterate(const NodeBlockMatrix<Dim>& K, const Eigen::VectorXd& R,
                                 Eigen::VectorXd& u) {
  constexpr double SINGULAR = 1e-10; // of pivots: bodies that are held have 1e-7 and more, others 1e-14
  IterationCounts& counts = m_iteration.counts();
  m_iteration.balance().set_coarse_gaps(true);
  do {
    const CondensedSystem& system =
        condense(K, u, R, m_iteration.options().terms, RightHandSide::TOTAL, false);
    Eigen::VectorXd z;
    {
      const CpuTimer timer(counts.factorization_seconds);
      ++counts.factorizations;
      const SparseView view{system.n, system.row_start.data(), system.col.data(), system.value.data(), false};
      if (m_solver.factorize(view) != FactorStatus::OK || m_solver.rcond() < SINGULAR) break;
      z = m_solver.solve(system.rhs);
    }
    expand(z, u);
    if (!again() || stop_asked()) return true;
  } while (pays([&] { return K; }));
  m_way.begin();
  m_iteration.policy().set_condensed(false);
  return false;
}

template <int Dim> void CondensedStep<Dim>::cut(Eigen::VectorXd& u, double fraction) {
  const char* where = "contact.cut";
  m_step.require_begun(where);
  if (m_step.stepping != Stepping::RATES)
    fail(where, "only a step of pure rates is linear: begin it with rates=true");
  require(fraction > 0 && fraction <= 1, where, "fraction", fraction, "0 < fraction <= 1");
  require(u.size() == m_step.u_start.size(), where, "size of u", u.size(), "number of dofs");
  u = (m_step.u_start + fraction * (u - m_step.u_start)).eval();
  shorten(m_iteration.model(), m_start, fraction, m_iteration.state());
  const Eigen::VectorXd& start = m_step.prescribed_start.value;
  m_step.prescribed.t = m_step.t + fraction * m_step.dt;
  m_step.prescribed.value = (start + fraction * (m_step.prescribed.value - start)).eval();
  m_step.dt *= fraction;
}

template struct StepUnderWay<2>;
template struct StepUnderWay<3>;
template class CondensedStep<2>;
template class CondensedStep<3>;

} // namespace burnish
