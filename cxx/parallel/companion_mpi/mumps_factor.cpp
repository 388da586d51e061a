#include "parallel/companion_mpi/mumps_factor.hpp"
#include <new>
#include <numeric>
#include <stdexcept>

// LAPACK: L of L L', in place.
extern "C" void dpotrf_(const char* uplo, const int* n, double* a, const int* lda, int* info,
                        std::size_t uplo_length);

namespace burnish {
namespace {

// Numbers of MUMPS's manual.
constexpr int BEGIN = -1, END = -2, ANALYZE = 1, FACTORIZE = 2, SOLVE = 3;
constexpr int POSITIVE_DEFINITE = 1;
constexpr int SINGULAR = -10, NOT_DEFINITE = -40, TOO_LITTLE_SPACE = -9, TOO_LITTLE_INTEGERS = -8,
              NO_MEMORY = -13;
constexpr int MORE_SPACE = 15, MOST_SPACE = 1000; // percent beyond what the analysis has estimated
constexpr int CONDENSE = 1, EXPAND = 2;           // halves of a solve
constexpr int BLOCK = 32;                         // right-hand sides at a time

} // namespace

MumpsFactor::~MumpsFactor() { end(); }

void MumpsFactor::end() {
  if (!m_begun) return;
  job(END, Meeting::RELEASE);
  m_begun = m_factorized = false;
}

void MumpsFactor::begin() {
  end();
  m_mumps = DMUMPS_STRUC_C{};
  m_mumps.comm_fortran = MPI_Comm_c2f(the_mpi_ranks().data());
  m_mumps.par = 1;
  m_mumps.sym = POSITIVE_DEFINITE;
  job(BEGIN, Meeting::ANALYZE);
  m_begun = true;
  for (const int output : {1, 2, 3, 4}) control(output) = output < 4 ? -1 : 0; // says nothing
  control(7) = 1;                                                              // the owner's order
  control(14) = MORE_SPACE;
  control(18) = 3; // every rank has a part of the matrix
  control(27) = BLOCK;
  control(28) = 1;
}

bool MumpsFactor::job(int number, Meeting what) const {
  the_mpi_ranks().meet(what, number);
  m_mumps.job = number;
  dmumps_c(&m_mumps);
  if (error() == NO_MEMORY) throw std::bad_alloc();
  return error() >= 0;
}

void MumpsFactor::analyze(std::vector<int> col_start, std::vector<int> row, int first) {
  begin();
  MpiRanks& all = the_mpi_ranks();
  m_size = static_cast<int>(col_start.size()) - 1;
  m_first = first < 0 ? m_size : first;
  m_num_entries = row.size();
  m_part = m_num_entries * all.rank() / all.size();
  m_part_end = m_num_entries * (all.rank() + 1) / all.size();
  m_row.clear();
  m_column.clear();
  for (int j = 0; j < m_size; ++j)
    for (std::size_t k = std::max<std::size_t>(col_start[j], m_part);
         k < std::min<std::size_t>(col_start[j + 1], m_part_end); ++k) {
      m_row.push_back(row[k] + 1);
      m_column.push_back(j + 1);
    }
  m_order.resize(m_size);
  std::iota(m_order.begin(), m_order.end(), 1);
  m_last.assign(m_order.begin() + m_first, m_order.end());
  m_mumps.n = m_size;
  m_mumps.nnz_loc = static_cast<MUMPS_INT8>(m_row.size());
  m_mumps.irn_loc = m_row.data();
  m_mumps.jcn_loc = m_column.data();
  m_mumps.perm_in = m_order.data();
  control(19) = num_last() > 0 ? 1 : 0; // the Schur complement of the last ones, on rank 0
  m_mumps.size_schur = num_last();
  m_mumps.listvar_schur = m_last.data();
  if (!job(ANALYZE, Meeting::ANALYZE))
    throw std::runtime_error("MumpsFactor::analyze: MUMPS error " + std::to_string(error()));
  const int numbers = m_mumps.infog[2]; // negative: millions
  m_entries = numbers >= 0 ? numbers : static_cast<std::size_t>(-static_cast<long>(numbers)) * 1000000;
  m_entries += static_cast<std::size_t>(num_last()) * num_last();
}

// What the analysis has estimated may be too little: again with more. @returns MUMPS's error
int MumpsFactor::run_factorization() const {
  while (!job(FACTORIZE, Meeting::FACTORIZE)) {
    const bool more = error() == TOO_LITTLE_SPACE || error() == TOO_LITTLE_INTEGERS;
    if (!more || control(14) >= MOST_SPACE) break;
    control(14) = 2 * control(14) + MORE_SPACE;
  }
  return error();
}

FactorStatus MumpsFactor::factorize(std::vector<double> values) {
  if (!m_begun) throw std::logic_error("MumpsFactor::factorize: call analyze first");
  if (values.size() != m_num_entries)
    throw std::logic_error("MumpsFactor::factorize: not as many values as rows of analyze");
  m_factorized = false;
  m_condensed_load.resize(0);
  values = std::vector<double>(values.begin() + m_part, values.begin() + m_part_end);
  m_schur.resize(num_last(), num_last());
  m_mumps.a_loc = values.data();
  m_mumps.schur = m_schur.data(); // by columns of its upper triangle
  const int found = run_factorization();
  m_mumps.a_loc = nullptr;
  if (found == SINGULAR || found == NOT_DEFINITE) return FactorStatus::NOT_POSITIVE_DEFINITE;
  if (found < 0) throw std::runtime_error("MumpsFactor::factorize: MUMPS error " + std::to_string(found));
  if (m_mumps.infog[11] > 0) return FactorStatus::NOT_POSITIVE_DEFINITE; // negative pivots
  const FactorStatus status = factorize_schur();
  m_factorized = status == FactorStatus::OK;
  return status;
}

FactorStatus MumpsFactor::factorize_schur() {
  const int n = num_last();
  if (n == 0) return FactorStatus::OK;
  int info = 0;
  if (the_mpi_ranks().rank() == 0) {
    m_schur.triangularView<Eigen::StrictlyLower>() = m_schur.transpose();
    dpotrf_("L", &n, m_schur.data(), &n, &info, 1);
    m_schur.triangularView<Eigen::StrictlyUpper>().setZero();
  }
  the_mpi_ranks().broadcast(&info, sizeof info, 0);
  if (info != 0) return FactorStatus::NOT_POSITIVE_DEFINITE;
  the_mpi_ranks().broadcast(m_schur.data(), sizeof(double) * m_schur.size(), 0);
  return FactorStatus::OK;
}

void MumpsFactor::require_factor(const char* where, Eigen::Index rows) const {
  if (!m_factorized) throw std::logic_error(std::string(where) + ": there is no factor");
  if (rows != m_size) throw std::logic_error(std::string(where) + ": b has not as many rows as the matrix");
}

// First half: b_c - L_ci L_ii^-1 b_i.
Eigen::VectorXd MumpsFactor::condensed(const Eigen::VectorXd& b) const {
  Eigen::VectorXd load = b, reduced(num_last());
  m_mumps.rhs = load.data();
  m_mumps.nrhs = 1;
  m_mumps.lrhs = m_size;
  m_mumps.redrhs = reduced.data();
  m_mumps.lredrhs = num_last();
  control(26) = CONDENSE;
  if (!job(SOLVE, Meeting::SOLVE))
    throw std::runtime_error("MumpsFactor::solve: MUMPS error " + std::to_string(error()));
  the_mpi_ranks().broadcast(reduced.data(), sizeof(double) * reduced.size(), 0);
  m_condensed_load = b;
  return reduced;
}

void MumpsFactor::solve_lower(Eigen::Ref<Eigen::MatrixXd> b) const {
  require_factor("MumpsFactor::solve_lower", b.rows());
  if (num_last() == 0) return;
  b.bottomRows(num_last()) = m_schur.triangularView<Eigen::Lower>().solve(condensed(b));
}

// MUMPS keeps one first half; of another load it is made again.
void MumpsFactor::solve_upper(Eigen::Ref<Eigen::MatrixXd> b) const {
  require_factor("MumpsFactor::solve_upper", b.rows());
  if (num_last() == 0) return solve(b);
  const bool kept =
      m_condensed_load.size() == m_size && m_condensed_load.head(m_first) == b.col(0).head(m_first);
  if (!kept) condensed(b);
  Eigen::VectorXd last = m_schur.transpose().triangularView<Eigen::Upper>().solve(b.bottomRows(num_last()));
  Eigen::VectorXd x(m_size);
  m_mumps.rhs = x.data();
  m_mumps.redrhs = last.data();
  control(26) = EXPAND;
  if (!job(SOLVE, Meeting::SOLVE))
    throw std::runtime_error("MumpsFactor::solve: MUMPS error " + std::to_string(error()));
  m_condensed_load.resize(0);
  the_mpi_ranks().broadcast(x.data(), sizeof(double) * x.size(), 0);
  b = x;
}

void MumpsFactor::solve(Eigen::Ref<Eigen::MatrixXd> b) const {
  require_factor("MumpsFactor::solve", b.rows());
  if (b.size() == 0) return;
  if (num_last() > 0) {
    for (Eigen::Index c = 0; c < b.cols(); ++c) {
      solve_lower(b.col(c));
      solve_upper(b.col(c));
    }
    return;
  }
  Eigen::MatrixXd x = b;
  m_mumps.rhs = x.data();
  m_mumps.nrhs = static_cast<int>(x.cols());
  m_mumps.lrhs = m_size;
  control(26) = 0;
  if (!job(SOLVE, Meeting::SOLVE))
    throw std::runtime_error("MumpsFactor::solve: MUMPS error " + std::to_string(error()));
  the_mpi_ranks().broadcast(x.data(), sizeof(double) * x.size(), 0);
  b = x;
}

Eigen::MatrixXd MumpsFactor::trailing_factor(int first) const {
  require_factor("MumpsFactor::trailing_factor", m_size);
  if (first != m_first) throw std::logic_error("MumpsFactor::trailing_factor: not the first of analyze");
  return m_schur;
}

} // namespace burnish
