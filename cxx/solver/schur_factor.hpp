#pragma once
// CHOLMOD factor of the symmetric tangent with the contact candidates ordered last, so that their Schur
// complement is the trailing block of the factor (METHOD.md 5.3).
#include "solver/body_solver.hpp"
#include <memory>

namespace burnish {

/// Supernodal LL' of the workpiece's tangent. Keeps its factor until the next factorize or changed analyze;
/// not for simultaneous use by several threads. Out of memory is std::bad_alloc; functions that need a factor
/// throw std::invalid_argument when there is none (before factorize, or after NOT_POSITIVE_DEFINITE).
template <int Dim> class SchurFactor final : public BodySolver<Dim> {
public:
  SchurFactor();
  ~SchurFactor() override;
  SchurFactor(SchurFactor&&) noexcept;
  SchurFactor& operator=(SchurFactor&&) noexcept;

  /// Ordering and symbolic analysis; cached: does nothing if pattern, fixed dofs and candidates are
  /// unchanged.
  /// @param fixed       Dim*num_nodes flags; fixed dofs are replaced by a unit diagonal
  /// @param candidates  nodes whose Dim dofs each are eliminated last, in this order; may be empty
  /// Fixed dofs of a candidate node stay among the candidates (unit diagonal).
  /// @throws std::invalid_argument if the pattern is not sorted, structurally symmetric and with all diagonal
  /// blocks, fixed is not of size Dim*num_nodes, a candidate is out of range or named twice; analysis and
  /// factor stay as they were. Beyond that the old ones are gone before the new analysis begins, so that no two are held.
  void analyze(const NodeBlockMatrix<Dim>& pattern, const std::vector<char>& fixed,
               const std::vector<int>& candidates) override;
  /// Numerical LL' of the lower triangle. NOT_POSITIVE_DEFINITE is a result, not an exception.
  /// @throws std::invalid_argument if the pattern is not the one analyzed, added has another size, or a value used is not finite
  /// (named by row, column and value)
  FactorStatus factorize(NodeBlockMatrix<Dim> matrix, const Eigen::VectorXd& added = {}) override;
  /// x = K^-1 b; entries of b at fixed dofs are taken as zero, x is zero there.
  /// @param b  Dim*num_nodes
  /// @throws std::invalid_argument if b has another size or is not finite at a free dof
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const override;
  /// @throws std::invalid_argument as solve
  SweptLoad sweep(const Eigen::VectorXd& b) const override;
  /// @throws std::invalid_argument if the load was not swept with a factor of this size
  Eigen::VectorXd candidate_displacement(const SweptLoad& load) const override;
  /// @throws std::invalid_argument as candidate_displacement, or if p has another size
  Eigen::VectorXd displacement(const SweptLoad& load, const Eigen::VectorXd& p) const override;
  /// Flexibility of the candidates C = S^-1 = (K^-1)_cc, symmetric, Dim*candidates square; zero rows and
  /// columns at fixed dofs. From the trailing block of L.
  std::shared_ptr<const Eigen::MatrixXd> candidate_flexibility() const override;
  /// Schur complement S = L_cc L_cc' of the candidates, Dim*candidates square; unit rows and columns at fixed
  /// dofs.
  Eigen::MatrixXd schur_complement() const;

  std::size_t factor_entries() const override;
  int analyses() const override; ///< counts since construction
  int factorizations() const;
  int solves() const; ///< solve and displacement

private:
  struct Impl;
  void release();
  std::unique_ptr<Impl> m_impl;
};

} // namespace burnish
