#pragma once
// The direct solver for condensed matrices: what scripts call "BURNISH" (ALGORITHMS.md 8.6).
#include "solver/bordered_solver.hpp"
#include "solver/unsymmetric_solver.hpp"
#include <memory>

namespace burnish {

/// BorderedSolver where the matrix is symmetric but for few rows, UnsymmetricSolver for all others. Keeps the analysis of
/// its last matrix.
class CondensedSolver {
public:
  /// @returns OK, or the status of UnsymmetricSolver; there is no factor then
  /// @throws std::invalid_argument for a damaged matrix or values that are not finite
  FactorStatus factorize(const SparseView& matrix);
  /// x = A^-1 b, or A'^-1 b. @throws std::invalid_argument without a factor, for a wrong size and NaN
  Eigen::VectorXd solve(const Eigen::VectorXd& b, bool transposed = false) const;
  bool bordered() const { return m_use_bordered; }

private:
  BorderedSolver m_bordered;
  UnsymmetricSolver m_general;
  bool m_use_bordered = false;
};

/// Solvers that wait for the next matrix of their kind: a caller whose own objects are made anew for each matrix, as
/// FreeFEM's are at every set(), keeps the analyses in here.
class SolverPool {
public:
  std::unique_ptr<CondensedSolver> take();
  /// Kept if fewer than `most` wait.
  void give_back(std::unique_ptr<CondensedSolver> solver);
  std::size_t waiting() const { return m_waiting.size(); }
  static constexpr std::size_t most = 4;

private:
  std::vector<std::unique_ptr<CondensedSolver>> m_waiting;
};

} // namespace burnish
