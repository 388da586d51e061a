#pragma once
// CHOLMOD factor of the symmetric tangent with the contact candidates ordered last, so that their Schur complement
// is the trailing block of the factor (method.md section 5).
#include "solver/node_block_matrix.hpp"
#include <memory>

namespace burnish {

enum class FactorStatus { OK, NOT_POSITIVE_DEFINITE };

template <int Dim> class SchurFactor {
public:
  SchurFactor();
  ~SchurFactor();
  SchurFactor(SchurFactor&&) noexcept;
  SchurFactor& operator=(SchurFactor&&) noexcept;

  /// Ordering and symbolic analysis; cached: does nothing if pattern, fixed dofs and candidates are unchanged.
  /// @param fixed       Dim*num_nodes flags; fixed dofs are replaced by a unit diagonal
  /// @param candidates  nodes whose Dim dofs each are eliminated last, in this order; may be empty
  /// Fixed dofs of a candidate node stay among the candidates (unit diagonal).
  void analyze(const NodeBlockMatrix<Dim>& pattern, const std::vector<char>& fixed, const std::vector<int>& candidates);
  /// Numerical LL' of the lower triangle. NOT_POSITIVE_DEFINITE is a result, not an exception.
  FactorStatus factorize(const NodeBlockMatrix<Dim>& matrix);
  /// x = K^-1 b; entries of b at fixed dofs are taken as zero, x is zero there.
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  /// Flexibility of the candidates C = S^-1 = (K^-1)_cc, symmetric, Dim*candidates square; zero rows and columns
  /// at fixed dofs. From the trailing block of L.
  Eigen::MatrixXd candidate_flexibility() const;
  /// Schur complement S = L_cc L_cc' of the candidates.
  Eigen::MatrixXd schur_complement() const;

  int analyses() const;        ///< counts since construction
  int factorizations() const;
  int solves() const;

private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace burnish
