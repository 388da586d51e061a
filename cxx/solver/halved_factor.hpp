#pragma once
// The factor of a divided body on two ranks.
#include "parallel/ranks.hpp"
#include "solver/cholmod_factor.hpp"

namespace burnish {

/// Two ranks, each with one half h of the interior and what separates the halves, s, and c, the last unknowns; the halves do not touch.
/// A rank factors A over its h and t = s + c by CHOLMOD. With the trailing block L_tt of each, the Schur complement of t is
/// the sum over both of L_tt L_tt', less A_tt; its factor is on both. Every call is one of both ranks with the same
/// arguments, and both get the same numbers (ALGORITHMS.md 20).
class HalvedFactor final : public OrderedFactor {
public:
  /// @param both two ranks, which outlive the factor
  explicit HalvedFactor(Ranks& both) : m_ranks(both) {}

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
  void analyze_own(const std::vector<int>& col_start, const std::vector<int>& row);
  bool all_well(bool here) const;
  Eigen::MatrixXd schur_complement(const std::vector<double>& values) const;
  void add_up(std::vector<double>& own) const;
  void require_factor(const char* where, Eigen::Index rows) const;
  int num_top() const { return static_cast<int>(m_top.size()); }

  Ranks& m_ranks;
  CholmodFactor m_own;               // over h and t
  std::vector<int> m_half[2], m_top; // unknowns of both halves and t, ascending
  std::vector<int> m_slot;           // per entry of m_own's triangle, its place among the values given
  // of each entry of A_tt: its place, and row and column in t
  std::vector<int> m_top_slot, m_top_row, m_top_column;
  Eigen::MatrixXd m_own_top, m_schur; // L_tt of this rank; the factor of the Schur complement
  std::size_t m_num_entries = 0, m_entries = 0;
  int m_size = 0;
  bool m_analyzed = false, m_factorized = false;
};

} // namespace burnish
