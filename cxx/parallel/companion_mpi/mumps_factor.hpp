#pragma once
// The factor of a divided body by MUMPS [MUMPS2001]. Only for the sources of this folder.
#include "parallel/companion_mpi/mpi_ranks.hpp"
#include "solver/ordered_factor.hpp"
#include <dmumps_c.h>

namespace burnish {

/// L_ii is divided among the ranks; L_cc, from the Schur complement of c, is on every one. Every call is one of all ranks with the
/// same arguments, of which each rank hands on a part, and all get the numbers that rank 0 gets.
class MumpsFactor final : public OrderedFactor {
public:
  MumpsFactor() = default;
  ~MumpsFactor() override;
  MumpsFactor(const MumpsFactor&) = delete;
  MumpsFactor& operator=(const MumpsFactor&) = delete;

  /// @throws std::runtime_error naming MUMPS's error, std::bad_alloc
  void analyze(std::vector<int> col_start, std::vector<int> row, int first = -1) override;
  FactorStatus factorize(std::vector<double> values) override;
  bool is_factorized() const override { return m_factorized; }
  void solve(Eigen::Ref<Eigen::MatrixXd> b) const override;
  /// b_i stays as it is.
  void solve_lower(Eigen::Ref<Eigen::MatrixXd> b) const override;
  void solve_upper(Eigen::Ref<Eigen::MatrixXd> b) const override;
  Eigen::MatrixXd trailing_factor(int first) const override;
  int size() const override { return m_size; }
  std::size_t factor_entries() const override { return m_entries; }

private:
  void begin();
  void end();
  bool job(int number, Meeting what) const;
  int run_factorization() const;
  FactorStatus factorize_schur();
  Eigen::VectorXd condensed(const Eigen::VectorXd& b) const;
  void require_factor(const char* where, Eigen::Index rows) const;
  int num_last() const { return m_size - m_first; }
  int& control(int number) const { return m_mumps.icntl[number - 1]; } // ICNTL of the manual
  int error() const { return m_mumps.infog[0]; }

  mutable DMUMPS_STRUC_C m_mumps{};
  mutable Eigen::VectorXd m_condensed_load; // that MUMPS keeps the first half of
  bool m_begun = false, m_factorized = false;
  int m_size = 0, m_first = 0;
  std::size_t m_num_entries = 0, m_part = 0, m_part_end = 0; // of the triangle, and this rank's of them
  std::size_t m_entries = 0;
  std::vector<int> m_row, m_column, m_order, m_last; // MUMPS counts from 1
  Eigen::MatrixXd m_schur;                           // L_cc
};

} // namespace burnish
