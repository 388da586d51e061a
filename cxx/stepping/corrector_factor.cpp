// The factored tangent of an iteration.
#include "base/cpu_time.hpp"
#include "base/error.hpp"
#include "solver/schur_factor.hpp"
#include "stepping/contact_window.hpp"
#include "stepping/corrector.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace burnish {
namespace {

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
FactorStatus Corrector<Dim>::factorize(const NodeBlockMatrix<Dim>& K, const Eigen::VectorXd& u) {
  require(K.size() == m_body.X.size(), "contact.factorize", "size of K", K.size(), "number of dofs");
  if (m_window.empty() || !window_covers(u))
    m_window =
        near_contact(m_model, m_body, m_state, u, m_options.window_width, m_options.window_nodes, m_options);
  m_rounding = rounding_of_forces(K, m_body.X);
  m_factor_age = 0;
  forget_mixing();
  if (!m_tangent || m_tangent.use_count() > 1) { // a saved state keeps its factor
    m_tangent = std::make_shared<FactoredTangent<Dim>>();
    m_tangent->solver = std::make_unique<SchurFactor<Dim>>();
  }
  m_tangent->window = m_window;
  {
    const CpuTimer timer(m_counts.factorization_seconds);
    const int analyses = m_tangent->solver->analyses();
    m_has_factor = m_tangent->factorize(m_model, m_body, m_state, K, m_floating) == FactorStatus::OK;
    if (!m_has_factor && !m_floating && m_indefinite >= m_options.max_indefinite) // no elastic moduli help
      m_has_factor = factorize_held(K, u) == FactorStatus::OK;
    m_counts.analyses += m_tangent->solver->analyses() - analyses;
  }
  ++m_counts.factorizations;
  m_counts.factor_entries = static_cast<long>(m_tangent->solver->factor_entries());
  m_rate.clear();
  if (!m_has_factor) {
    ++m_indefinite;
    if (blend_exhausted()) m_reason = UNSTABLE;
    return FactorStatus::NOT_POSITIVE_DEFINITE;
  }
  m_indefinite = 0;
  ++m_step_factorizations;
  if (!m_tangent->flexibility || m_tangent->added_stiffness.size() == 0 || m_floating) {
    const CpuTimer timer(m_counts.condensation_seconds);
    m_tangent->condense();
    m_flexibility.set(m_tangent->flexibility);
  }
  return FactorStatus::OK;
}

// A body that is not stable alone may be so between its tools: the factor is one of the body held at its contact nodes,
// and the dense block, which lets go of them again, tells (METHOD.md 5.6).
template <int Dim>
FactorStatus Corrector<Dim>::factorize_held(const NodeBlockMatrix<Dim>& K, const Eigen::VectorXd& u) {
  if (m_R.size() != u.size()) return FactorStatus::NOT_POSITIVE_DEFINITE;
  const FactorStatus status = m_tangent->factorize(m_model, m_body, m_state, K, true);
  if (status != FactorStatus::OK) return status;
  m_tangent->condense();
  m_flexibility.set(m_tangent->flexibility);
  WindowProblem<Dim> problem = window_problem(u, m_R, m_tangent->solver->sweep(-m_R));
  problem.adapt = false;
  return solve_window(m_model, m_body, m_prescribed, m_state, problem).unstable
             ? FactorStatus::NOT_POSITIVE_DEFINITE
             : FactorStatus::OK;
}

template <int Dim> double Corrector<Dim>::elastic_blend() const {
  const auto entry = [](const std::array<double, 4>& table, int i) { return table[std::min(i, 3)]; };
  return std::max(entry(m_options.blend_by_factorization, m_step_factorizations),
                  entry(m_options.blend_by_failure, m_indefinite));
}

template <int Dim> double Corrector<Dim>::compliance() const {
  if (!m_has_factor || !m_tangent->flexibility) return 0;
  return m_tangent->flexibility->diagonal().maxCoeff();
}

#define BURNISH_INSTANTIATE(Dim)                                                                             \
  template FactorStatus Corrector<Dim>::factorize(const NodeBlockMatrix<Dim>&, const Eigen::VectorXd&);      \
  template FactorStatus Corrector<Dim>::factorize_held(const NodeBlockMatrix<Dim>&, const Eigen::VectorXd&); \
  template double Corrector<Dim>::compliance() const;                                                        \
  template double Corrector<Dim>::elastic_blend() const;
BURNISH_INSTANTIATE(2)
BURNISH_INSTANTIATE(3)

} // namespace burnish
