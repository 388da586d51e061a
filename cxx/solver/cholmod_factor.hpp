#pragma once
// Supernodal LL' of a sparse symmetric matrix that its owner has already permuted.
#include "solver/factor_status.hpp"
#include <Eigen/Dense>
#include <memory>
#include <vector>

namespace burnish {

/// CHOLMOD without an ordering of its own: column k is eliminated at k, so that the owner decides what comes
/// last. Not for simultaneous use by several threads (solve uses the object's workspace).
class CholmodFactor {
public:
  CholmodFactor();
  ~CholmodFactor();
  CholmodFactor(CholmodFactor&&) noexcept;
  CholmodFactor& operator=(CholmodFactor&&) noexcept;

  /// Symbolic analysis of the pattern of the lower triangle by columns: rows row[col_start[j] ..
  /// col_start[j+1]), each >= j, in any order; the last entry of col_start is the number of entries.
  /// @throws std::bad_alloc, std::runtime_error on a CHOLMOD error; ArgumentError if the factor is larger than memory_left()
  void analyze(std::vector<int> col_start, std::vector<int> row);
  /// Numerical factor of the matrix with these values, in the order of `row` of analyze(); they are not kept. After
  /// NOT_POSITIVE_DEFINITE there is no factor to use.
  /// @throws std::logic_error before analyze() or for another number of values; std::bad_alloc, std::runtime_error on a CHOLMOD error
  FactorStatus factorize(std::vector<double> values);
  bool is_factorized() const;
  /// Replaces every column of b (n x any number) by A^-1 b.
  /// @throws std::logic_error if there is no factor or b has not n rows
  void solve(Eigen::Ref<Eigen::MatrixXd> b) const;
  /// The halves of solve: every column b becomes L^-1 b, or L'^-1 b.
  void solve_lower(Eigen::Ref<Eigen::MatrixXd> b) const;
  void solve_upper(Eigen::Ref<Eigen::MatrixXd> b) const;
  /// Trailing block L(first:n, first:n), lower triangular; first <= n.
  /// @throws std::logic_error if there is no factor or first is out of range
  Eigen::MatrixXd trailing_factor(int first) const;
  int size() const;
  /// Entries stored in L, zeros inside supernodes included; 0 before analyze().
  std::size_t factor_entries() const;

private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace burnish
