#pragma once
// The body's tangent in a sparse solver of its own order: the flexibility of the candidates comes in parts, each when it is first
// needed (ALGORITHMS.md 8.7): by columns of L^-1 where L can be read, else by columns of K^-1.
#include "solver/body_solver.hpp"
#include "solver/sparse_solver.hpp"
#include <memory>

namespace burnish {

/// Keeps the solver's analysis while the pattern and the fixed dofs stay; the candidates may change. K need not be symmetric
/// where the solver takes whole matrices.
template <int Dim> class ColumnFactor final : public BodySolver<Dim> {
public:
  /// @param solver must outlive it; it serves one ColumnFactor at a time
  explicit ColumnFactor(std::unique_ptr<SparseSolver> solver);
  ~ColumnFactor() override;

  /// @throws std::invalid_argument if fixed is not of size Dim*num_nodes or a candidate is out of range
  void analyze(const NodeBlockMatrix<Dim>& pattern, const std::vector<char>& fixed,
               const std::vector<int>& candidates) override;
  /// The factor is tried on two right-hand sides. NOT_POSITIVE_DEFINITE: a symmetric K with b'K^-1 b < 0 for one of them,
  /// which an indefinite K need not show, or a solver of symmetric matrices that has not solved it; SINGULAR: another
  /// solver has not solved it.
  /// @throws std::invalid_argument if the pattern is not the one analyzed, added has another size, or a value is not finite
  FactorStatus factorize(NodeBlockMatrix<Dim> matrix, const Eigen::VectorXd& added = {}) override;
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const override;
  /// The whole solution: y = K^-1 b.
  SweptLoad sweep(const Eigen::VectorXd& b) const override;
  Eigen::VectorXd candidate_displacement(const SweptLoad& load) const override;
  /// A sum of columns: no further solve where the loaded components are known, but the second half of one.
  Eigen::VectorXd displacement(const SweptLoad& load, const Eigen::VectorXd& p) const override;
  /// Rows and columns of the known components, and zeros behind them.
  std::shared_ptr<const Eigen::MatrixXd> candidate_flexibility() const override;
  bool in_parts() const override { return true; }
  /// @throws std::invalid_argument if a component is fixed
  std::vector<int> complete_flexibility(const std::vector<int>& components) const override;
  Eigen::VectorXd displacement_under(const Eigen::VectorXd& p) const override;
  std::vector<std::vector<int>> solved_columns() const override;
  void solve_columns(const std::vector<std::vector<int>>& calls) override;
  bool symmetric() const override;
  std::size_t factor_entries() const override; ///< 0: the solver does not say
  int analyses() const override;
  long columns() const; ///< made since construction

private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace burnish
