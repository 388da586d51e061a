#pragma once
// CHOLMOD's factor of a whole symmetric matrix in an order of little fill, as ColumnFactor uses it.
#include "solver/sparse_solver.hpp"
#include <memory>

namespace burnish {

/// Supernodal LL', of a divided body by MUMPS. Its refusal of a matrix that is not positive definite is exact.
class CholmodSolver final : public SparseSolver {
public:
  /// @param dim of the body
  explicit CholmodSolver(int dim = 2);
  ~CholmodSolver() override;
  bool symmetric() const override { return true; }
  void analyze(const SparseView& pattern) override;
  /// @returns false for a matrix that is not positive definite
  bool factorize(const double* value) override;
  void solve(Eigen::MatrixXd& B) override;
  std::unique_ptr<HalfColumns> half_columns() const override;
  Eigen::VectorXd second_half(Eigen::VectorXd y) const override;
  std::size_t factor_entries() const override;

private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace burnish
