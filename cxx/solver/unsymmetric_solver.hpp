#pragma once
// UMFPACK: the general solver, as a check of BorderedSolver and for matrices that it declines.
#include "solver/factor_status.hpp"
#include "solver/sparse_view.hpp"
#include <Eigen/Dense>
#include <memory>

namespace burnish {

/// Sparse LU with the symbolic analysis kept while the pattern stays the same. Solves with UMFPACK's
/// iterative refinement. Not for simultaneous use by several threads.
class UnsymmetricSolver {
public:
  UnsymmetricSolver();
  ~UnsymmetricSolver();
  UnsymmetricSolver(UnsymmetricSolver&&) noexcept;
  UnsymmetricSolver& operator=(UnsymmetricSolver&&) noexcept;

  /// The matrix is copied. SINGULAR is a result, after it there is no factor.
  /// @throws std::invalid_argument on a bad pattern (see SparsePattern) or a value that is not finite;
  /// std::bad_alloc; std::runtime_error on another UMFPACK error; there is no factor then
  FactorStatus factorize(const SparseView& matrix);
  /// x = A^-1 b.
  /// @throws std::invalid_argument if there is no factor, b is not of size n or not finite
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  /// x = A'^-1 b, errors as solve.
  Eigen::VectorXd solve_transposed(const Eigen::VectorXd& b) const;
  double rcond()
      const; ///< least over largest pivot of the last factor: a rough reciprocal condition, 0 of a singular matrix
  int analyses() const; ///< symbolic analyses since construction

private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace burnish
