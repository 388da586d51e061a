#pragma once
// Direct solver for matrices that are symmetric except in few rows or columns, as the condensed contact
// matrix is: friction spoils the symmetry of the contact rows only (METHOD.md 5.3).
#include "solver/factor_status.hpp"
#include "solver/sparse_view.hpp"
#include <Eigen/Dense>
#include <memory>

namespace burnish {

/// A = [B E; F D] with D the border: few indices whose removal leaves B symmetric. B = LL' by CHOLMOD, then
/// the dense S = D - F B^-1 E by LU with row pivoting. The analysis is kept while the pattern is the same and
/// the border covers every violation of symmetry (a new one is chosen when less than half of it would do).
/// Not for simultaneous use by several threads.
class BorderedSolver {
public:
  /// @param max_border  largest border treated densely, >= 0
  /// @throws std::invalid_argument if max_border < 0
  explicit BorderedSolver(int max_border = 2000);
  ~BorderedSolver();
  BorderedSolver(BorderedSolver&&) noexcept;
  BorderedSolver& operator=(BorderedSolver&&) noexcept;

  /// Entries a_ij and a_ji count as equal if they differ by at most 1e-14 of the largest entry of row i and
  /// of row j; the lower one is used then. The matrix is copied.
  /// @return NOT_POSITIVE_DEFINITE if B is not, SINGULAR if S is to rounding, BORDER_TOO_LARGE: there is no
  /// factor then, UnsymmetricSolver may do; OK otherwise
  /// @throws std::invalid_argument on a bad pattern (see SparsePattern) or a value that is not finite, there
  /// is no factor then; std::bad_alloc; std::runtime_error on another CHOLMOD error
  FactorStatus factorize(const SparseView& matrix);
  /// x = A^-1 b.
  /// @throws std::invalid_argument if there is no factor, b is not of size n or not finite
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  /// x = A'^-1 b, errors as solve.
  Eigen::VectorXd solve_transposed(const Eigen::VectorXd& b) const;

  /// Indices in the border of the last factorize; after BORDER_TOO_LARGE, 0.
  int border_size() const;
  int analyses() const; ///< symbolic analyses since construction

private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace burnish
