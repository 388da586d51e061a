#include "solver/condensed_solver.hpp"

namespace burnish {

FactorStatus CondensedSolver::factorize(const SparseView& matrix) {
  m_use_bordered = m_bordered.factorize(matrix) == FactorStatus::OK;
  return m_use_bordered ? FactorStatus::OK : m_general.factorize(matrix);
}

Eigen::VectorXd CondensedSolver::solve(const Eigen::VectorXd& b, bool transposed) const {
  if (m_use_bordered) return transposed ? m_bordered.solve_transposed(b) : m_bordered.solve(b);
  return transposed ? m_general.solve_transposed(b) : m_general.solve(b);
}

std::unique_ptr<CondensedSolver> SolverPool::take() {
  if (m_waiting.empty()) return std::make_unique<CondensedSolver>();
  auto solver = std::move(m_waiting.back());
  m_waiting.pop_back();
  return solver;
}

void SolverPool::give_back(std::unique_ptr<CondensedSolver> solver) {
  if (m_waiting.size() < most) m_waiting.push_back(std::move(solver));
}

} // namespace burnish
