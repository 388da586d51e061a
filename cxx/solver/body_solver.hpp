#pragma once
// What the contact needs of a solver for the body's tangent: factor, solve, flexibility of the candidates.
#include "solver/factor_status.hpp"
#include "solver/node_block_matrix.hpp"

namespace burnish {

/// One symmetric positive definite tangent at a time. Implementations: SchurFactor (CHOLMOD).
template <int Dim> class BodySolver {
public:
  virtual ~BodySolver() = default;
  /// Prepares for a pattern; does nothing if pattern, fixed dofs and candidates are those of the last call.
  /// @param fixed       Dim*num_nodes flags; the displacement is given there
  /// @param candidates  nodes whose flexibility will be asked for, in this order; may be empty
  virtual void analyze(const NodeBlockMatrix<Dim>& pattern, const std::vector<char>& fixed,
                       const std::vector<int>& candidates) = 0;
  /// NOT_POSITIVE_DEFINITE is a result, not an exception; it leaves no factor.
  virtual FactorStatus factorize(const NodeBlockMatrix<Dim>& matrix) = 0;
  /// x = K^-1 b, Dim*num_nodes; zero at fixed dofs. [length for b in force]
  virtual Eigen::VectorXd solve(const Eigen::VectorXd& b) const = 0;
  /// C = (K^-1)_cc on the candidates, symmetric, Dim*candidates square; zero rows and columns at fixed dofs
  /// [length/force].
  virtual Eigen::MatrixXd candidate_flexibility() const = 0;
  virtual int analyses() const = 0; ///< number of analyses made, cached ones not counted
};

} // namespace burnish
