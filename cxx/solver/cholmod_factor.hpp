#pragma once
// Supernodal LL' of a sparse symmetric matrix that its owner has already permuted.
#include "solver/ordered_factor.hpp"

namespace burnish {

/// CHOLMOD without an ordering of its own: column k is eliminated at k, so that the owner decides what comes
/// last. Not for simultaneous use by several threads (solve uses the object's workspace).
class CholmodFactor final : public OrderedFactor {
public:
  CholmodFactor();
  ~CholmodFactor() override;
  CholmodFactor(CholmodFactor&&) noexcept;
  CholmodFactor& operator=(CholmodFactor&&) noexcept;

  /// @param first is not needed
  void analyze(std::vector<int> col_start, std::vector<int> row, int first = -1) override;
  FactorStatus factorize(std::vector<double> values) override;
  bool is_factorized() const override;
  void solve(Eigen::Ref<Eigen::MatrixXd> b) const override;
  /// Every column b becomes L^-1 b, or L'^-1 b.
  void solve_lower(Eigen::Ref<Eigen::MatrixXd> b) const override;
  void solve_upper(Eigen::Ref<Eigen::MatrixXd> b) const override;
  /// Trailing block L(first:n, first:n), lower triangular; any first <= n.
  /// @throws std::logic_error if there is no factor or first is out of range
  Eigen::MatrixXd trailing_factor(int first) const override;
  std::optional<Supernodes> supernodes() const override;
  int size() const override;
  /// Zeros inside supernodes included.
  std::size_t factor_entries() const override;

private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace burnish
