#pragma once
// UMFPACK behind the interface of a host program's solver: the same factor as FreeFEM's, many right-hand sides at once.
#include "solver/sparse_solver.hpp"
#include <memory>

namespace burnish {

/// Solves without iterative refinement; ColumnFactor looks at the residual.
class UmfpackSolver final : public SparseSolver {
public:
  UmfpackSolver();
  ~UmfpackSolver() override;
  bool symmetric() const override { return false; }
  void analyze(const SparseView& pattern) override;
  /// @throws std::bad_alloc
  bool factorize(const double* value) override;
  void solve(Eigen::MatrixXd& B) override;

private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace burnish
