#pragma once
// The factor of a divided body on two ranks.
#include "parallel/ranks.hpp"
#include "solver/cholmod_factor.hpp"

namespace burnish {

/// Of two ranks, each orders its half.
/// @param graph of what is eliminated before c
/// @throws as fill_reducing_order
EliminationOrder order_of_halves(const Graph& graph, Ordering ordering, Ranks& both);

/// Two ranks, each with one half h of the interior and what separates the halves, s, and c, the last unknowns; the halves do not touch.
/// A rank factors A over its h and t = s + c by CHOLMOD. With the trailing block L_tt of each, the Schur complement of t is
/// the sum over both of L_tt L_tt', less A_tt; its factor is on both. Every call is one of both ranks with the same
/// arguments, and both get the same numbers (ALGORITHMS.md 20).
class HalvedFactor final : public OrderedFactor {
public:
  /// @param both   two ranks, which outlive the factor
  /// @param halves unknowns of either half, the first in the order
  HalvedFactor(Ranks& both, const std::array<int, 2>& halves) : m_ranks(both), m_halves(halves) {}

  /// @throws std::logic_error if the halves touch
  void analyze(std::vector<int> col_start, std::vector<int> row, int first = -1) override;
  FactorStatus factorize(std::vector<double> values) override;
  bool is_factorized() const override { return m_factorized; }
  void solve(Eigen::Ref<Eigen::MatrixXd> b) const override;
  /// Of b_i, this rank's half and s change. Any number of columns.
  void solve_lower(Eigen::Ref<Eigen::MatrixXd> b) const override;
  void solve_upper(Eigen::Ref<Eigen::MatrixXd> b) const override;
  Eigen::MatrixXd trailing_factor(int first) const override;
  int size() const override { return m_size; }
  /// Of both ranks.
  std::size_t factor_entries() const override { return m_entries; }

private:
  bool all_well(bool here) const;
  void form_schur_complement(const std::vector<double>& values);
  void add_up(double* own, std::size_t n) const;
  void require_factor(const char* where, Eigen::Index rows) const;
  int begin_of(int half) const { return half == 0 ? 0 : m_halves[0]; }
  int own_half() const { return m_halves[m_ranks.rank()]; }
  int num_top() const { return m_size - m_halves[0] - m_halves[1]; }

  Ranks& m_ranks;
  std::array<int, 2> m_halves;
  CholmodFactor m_own; // over h and t
  // entries of A over h and over t: from the first to before the second
  std::array<std::size_t, 2> m_half_entries{}, m_top_entries{};
  std::vector<int> m_top_row, m_top_column; // of each entry over t, there
  Eigen::MatrixXd m_own_top, m_schur;       // L_tt of this rank; the factor of the Schur complement
  std::vector<double> m_packed;             // the same before it is factored
  mutable std::vector<double> m_exchange;   // numbers of both ranks
  std::size_t m_entries = 0;
  int m_size = 0;
  bool m_analyzed = false, m_factorized = false;
};

} // namespace burnish
