#include "solver/halved_factor.hpp"
#include "solver/fill_ordering.hpp"
#include <algorithm>
#include <stdexcept>
#include <utility>

// LAPACK, in place: L of L L'; U U' from U.
extern "C" void dpotrf_(const char* uplo, const int* n, double* a, const int* lda, int* info,
                        std::size_t uplo_length);
extern "C" void dlauum_(const char* uplo, const int* n, double* a, const int* lda, int* info,
                        std::size_t uplo_length);

namespace burnish {
namespace {

// L L', its lower triangle by columns. dlauum forms U U': L read backwards is a U.
std::vector<double> packed_product(const Eigen::MatrixXd& L) {
  const int n = static_cast<int>(L.rows());
  Eigen::MatrixXd backwards = L.reverse();
  int info = 0;
  if (n > 0) dlauum_("U", &n, backwards.data(), &n, &info, 1);
  std::vector<double> packed;
  packed.reserve(static_cast<std::size_t>(n) * (n + 1) / 2);
  for (int j = 0; j < n; ++j)
    for (int i = j; i < n; ++i) packed.push_back(backwards(n - 1 - i, n - 1 - j));
  return packed;
}

} // namespace

void HalvedFactor::analyze(std::vector<int> col_start, std::vector<int> row, int first) {
  m_analyzed = m_factorized = false;
  m_size = static_cast<int>(col_start.size()) - 1;
  m_num_entries = row.size();
  const int num_interior = first < 0 ? m_size : first;
  m_half[0].clear();
  m_half[1].clear();
  m_top.clear();
  Graph interior;
  for (int j = 0; j < num_interior; ++j) {
    for (int k = col_start[j]; k < col_start[j + 1]; ++k)
      if (row[k] < num_interior) interior.col.push_back(row[k]);
    interior.row_start.push_back(static_cast<int>(interior.col.size()));
  }
  std::vector<int> part = halves_and_separator(interior);
  m_ranks.broadcast(part.data(), sizeof(int) * part.size(), 0);
  for (int j = 0; j < m_size; ++j)
    (j >= num_interior || part[j] == SEPARATOR ? m_top : m_half[part[j]]).push_back(j);
  analyze_own(col_start, row);
  std::vector<double> entries{static_cast<double>(m_own.factor_entries())};
  add_up(entries);
  m_entries = static_cast<std::size_t>(entries[0]);
  m_analyzed = true;
}

// The pattern over this rank's half and t, in the order given: of unknowns that are left out or moved to the end comes no fill.
void HalvedFactor::analyze_own(const std::vector<int>& col_start, const std::vector<int>& row) {
  const std::vector<int>& half = m_half[m_ranks.rank()];
  const int num_own = static_cast<int>(half.size());
  std::vector<int> place(m_size, -1);
  for (int k = 0; k < num_own; ++k) place[half[k]] = k;
  for (int k = 0; k < num_top(); ++k) place[m_top[k]] = num_own + k;
  std::vector<int> start(num_own + num_top() + 1, 0);
  const auto for_entries = [&](auto&& f) {
    for (int j = 0; j < m_size; ++j)
      for (int k = col_start[j]; place[j] >= 0 && k < col_start[j + 1]; ++k)
        if (place[row[k]] >= 0) f(k, std::max(place[j], place[row[k]]), std::min(place[j], place[row[k]]));
  };
  m_top_slot.clear();
  m_top_row.clear();
  m_top_column.clear();
  for_entries([&](int k, int i, int j) {
    ++start[j + 1];
    if (j < num_own) return;
    m_top_slot.push_back(k);
    m_top_row.push_back(i - num_own);
    m_top_column.push_back(j - num_own);
  });
  for (std::size_t j = 1; j < start.size(); ++j) start[j] += start[j - 1];
  std::vector<int> next(start.begin(), start.end() - 1), rows(start.back());
  m_slot.resize(rows.size());
  for_entries([&](int k, int i, int j) {
    const int at = next[j]++;
    rows[at] = i;
    m_slot[at] = k;
  });
  m_own.analyze(std::move(start), std::move(rows));
}

bool HalvedFactor::all_well(bool here) const { return m_ranks.least(here ? 1 : 0) == 1; }

// Own numbers become the sum of both ranks', in the same order on both.
void HalvedFactor::add_up(std::vector<double>& own) const {
  const std::size_t n = own.size();
  std::vector<double> both(2 * n);
  std::copy(own.begin(), own.end(), both.begin() + n * m_ranks.rank());
  m_ranks.gather(both.data(), {0, n, 2 * n});
  for (std::size_t k = 0; k < n; ++k) own[k] = both[k] + both[n + k];
}

Eigen::MatrixXd HalvedFactor::schur_complement(const std::vector<double>& values) const {
  std::vector<double> packed = packed_product(m_own_top);
  add_up(packed);
  Eigen::MatrixXd schur = Eigen::MatrixXd::Zero(num_top(), num_top());
  const double* from = packed.data();
  for (int j = 0; j < num_top(); ++j)
    for (int i = j; i < num_top(); ++i) schur(i, j) = *from++;
  for (std::size_t k = 0; k < m_top_slot.size(); ++k)
    schur(m_top_row[k], m_top_column[k]) -= values[m_top_slot[k]];
  return schur;
}

FactorStatus HalvedFactor::factorize(std::vector<double> values) {
  if (!m_analyzed) throw std::logic_error("HalvedFactor::factorize: call analyze first");
  if (values.size() != m_num_entries)
    throw std::logic_error("HalvedFactor::factorize: not as many values as rows of analyze");
  m_factorized = false;
  std::vector<double> own(m_slot.size());
  for (std::size_t k = 0; k < own.size(); ++k) own[k] = values[m_slot[k]];
  if (!all_well(m_own.factorize(std::move(own)) == FactorStatus::OK))
    return FactorStatus::NOT_POSITIVE_DEFINITE;
  m_own_top = m_own.trailing_factor(static_cast<int>(m_half[m_ranks.rank()].size()));
  m_schur = schur_complement(values);
  const int n = num_top();
  int info = 0;
  if (n > 0) dpotrf_("L", &n, m_schur.data(), &n, &info, 1);
  if (!all_well(info == 0)) return FactorStatus::NOT_POSITIVE_DEFINITE;
  m_factorized = true;
  return FactorStatus::OK;
}

void HalvedFactor::require_factor(const char* where, Eigen::Index rows) const {
  if (!m_factorized) throw std::logic_error(std::string(where) + ": there is no factor");
  if (rows != m_size) throw std::logic_error(std::string(where) + ": b has not as many rows as the matrix");
}

// y_h = L_hh^-1 b_h; both ranks' -L_th y_h, which is L_tt times the end of the own solution, are added to b_t.
void HalvedFactor::solve_lower(Eigen::Ref<Eigen::MatrixXd> b) const {
  require_factor("HalvedFactor::solve_lower", b.rows());
  if (b.size() == 0) return;
  const std::vector<int>& half = m_half[m_ranks.rank()];
  Eigen::MatrixXd y = Eigen::MatrixXd::Zero(m_own.size(), b.cols());
  y.topRows(half.size()) = b(half, Eigen::all);
  m_own.solve_lower(y);
  b(half, Eigen::all) = y.topRows(half.size());
  std::vector<double> change(static_cast<std::size_t>(num_top()) * b.cols());
  Eigen::Map<Eigen::MatrixXd> on_top(change.data(), num_top(), b.cols());
  for (Eigen::Index c = 0; c < b.cols(); ++c) // of one column Eigen makes no copy of the triangle
    on_top.col(c) = m_own_top.triangularView<Eigen::Lower>() * y.col(c).tail(num_top());
  add_up(change);
  Eigen::MatrixXd top = b(m_top, Eigen::all) + on_top;
  for (auto column : top.colwise()) m_schur.triangularView<Eigen::Lower>().solveInPlace(column);
  b(m_top, Eigen::all) = top;
}

// x_t, then x_h = L_hh'^-1 (y_h - L_th' x_t) of both ranks.
void HalvedFactor::solve_upper(Eigen::Ref<Eigen::MatrixXd> b) const {
  require_factor("HalvedFactor::solve_upper", b.rows());
  if (b.size() == 0) return;
  Eigen::MatrixXd top = b(m_top, Eigen::all);
  for (auto column : top.colwise()) m_schur.triangularView<Eigen::Lower>().transpose().solveInPlace(column);
  b(m_top, Eigen::all) = top;
  const std::vector<int>& half = m_half[m_ranks.rank()];
  Eigen::MatrixXd x(m_own.size(), b.cols());
  x.topRows(half.size()) = b(half, Eigen::all);
  for (Eigen::Index c = 0; c < b.cols(); ++c)
    x.col(c).tail(num_top()) = m_own_top.triangularView<Eigen::Lower>().transpose() * top.col(c);
  m_own.solve_upper(x);
  const std::size_t cols = b.cols(), first = m_half[0].size() * cols, all = first + m_half[1].size() * cols;
  std::vector<double> both(all);
  const auto of = [&](int r) {
    return Eigen::Map<Eigen::MatrixXd>(both.data() + (r == 0 ? 0 : first), m_half[r].size(), b.cols());
  };
  of(m_ranks.rank()) = x.topRows(half.size());
  m_ranks.gather(both.data(), {0, first, all});
  for (int r : {0, 1}) b(m_half[r], Eigen::all) = of(r);
}

void HalvedFactor::solve(Eigen::Ref<Eigen::MatrixXd> b) const {
  solve_lower(b);
  solve_upper(b);
}

Eigen::MatrixXd HalvedFactor::trailing_factor(int first) const {
  require_factor("HalvedFactor::trailing_factor", m_size);
  const auto begin = std::lower_bound(m_top.begin(), m_top.end(), first);
  const auto count = m_top.end() - begin;
  if (count != m_size - first)
    throw std::logic_error("HalvedFactor::trailing_factor: not the first of analyze");
  Eigen::MatrixXd block = m_schur.bottomRightCorner(count, count).triangularView<Eigen::Lower>();
  return block;
}

} // namespace burnish
