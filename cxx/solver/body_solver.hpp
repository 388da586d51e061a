#pragma once
// What the contact needs of a solver for the body's tangent: factor, solve, flexibility of the candidates.
#include "solver/factor_status.hpp"
#include "solver/node_block_matrix.hpp"
#include <memory>

namespace burnish {

/// A load half way to its displacement: solution of L y = b with the factor L L', in the order of elimination; of a solver that
/// knows no half ways, K^-1 b. Valid until the next factorize.
struct SweptLoad {
  Eigen::VectorXd y;
};

/// One tangent at a time. Implementations: SchurFactor (candidates last), ColumnFactor (columns).
template <int Dim> class BodySolver {
public:
  virtual ~BodySolver() = default;
  /// Prepares for a pattern; does nothing if pattern, fixed dofs and candidates are those of the last call.
  /// @param fixed       Dim*num_nodes flags; the displacement is given there
  /// @param candidates  nodes whose flexibility will be asked for, in this order; may be empty
  virtual void analyze(const NodeBlockMatrix<Dim>& pattern, const std::vector<char>& fixed,
                       const std::vector<int>& candidates) = 0;
  /// NOT_POSITIVE_DEFINITE and SINGULAR are results, not exceptions; they leave no factor.
  /// @param matrix what is moved here is freed before the factor is made: large bodies do not hold both
  /// @param added  put onto the diagonal at the candidates, Dim*candidates [force/length]; empty: none. Not at fixed dofs
  virtual FactorStatus factorize(NodeBlockMatrix<Dim> matrix, const Eigen::VectorXd& added = {}) = 0;
  /// x = K^-1 b, Dim*num_nodes; zero at fixed dofs. [length for b in force]
  virtual Eigen::VectorXd solve(const Eigen::VectorXd& b) const = 0;
  /// First half of a solve, L y = b: what a load on the candidates adds comes later (METHOD.md 5.3).
  /// @param b  Dim*num_nodes [force]; entries at fixed dofs are taken as zero
  virtual SweptLoad sweep(const Eigen::VectorXd& b) const = 0;
  /// (K^-1 b)_c of a swept load b, Dim*candidates; zero at fixed dofs [length].
  virtual Eigen::VectorXd candidate_displacement(const SweptLoad& load) const = 0;
  /// Second half: K^-1 (b + p) of a swept load b, Dim*num_nodes; zero at fixed dofs [length].
  /// @param p  further load on the candidates, Dim*candidates [force]
  virtual Eigen::VectorXd displacement(const SweptLoad& load, const Eigen::VectorXd& p) const = 0;
  /// C = (K^-1)_cc on the candidates, Dim*candidates square; zero rows and columns at fixed dofs [length/force]. Where it is known in
  /// parts, rows and columns stand where complete_flexibility says, and it grows.
  virtual std::shared_ptr<const Eigen::MatrixXd> candidate_flexibility() const = 0;
  virtual bool in_parts() const { return false; }
  /// Makes sure of rows and columns of C. @param components places among the Dim*candidates, free ones
  /// @returns their places in C
  virtual std::vector<int> complete_flexibility(const std::vector<int>& components) const {
    return components;
  }
  /// C p, Dim*candidates [length], of a C in parts. @param p [force]
  virtual Eigen::VectorXd displacement_under(const Eigen::VectorXd& p) const { return p; }
  /// Degrees of freedom of the known parts of C, call by call; the same calls of solve_columns make
  /// them known to another factor of the same matrix to the same bits. None where C is there as a whole.
  virtual std::vector<std::vector<int>> solved_columns() const { return {}; }
  virtual void solve_columns(const std::vector<std::vector<int>>& /*calls*/) {}
  virtual bool symmetric() const { return true; } ///< the tangent that was factored last
  virtual std::size_t factor_entries() const = 0; ///< numbers stored in the factor; 0 before analyze
  virtual int analyses() const = 0;               ///< number of analyses made, cached ones not counted
};

} // namespace burnish
