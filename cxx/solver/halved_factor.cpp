#include "solver/halved_factor.hpp"
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

// L L', its lower triangle by columns, to the beginning of `to`. dlauum forms U U': L read backwards is a U. `work` is lost.
void packed_product(const Eigen::MatrixXd& L, Eigen::MatrixXd& work, std::vector<double>& to) {
  const int n = static_cast<int>(L.rows());
  work = L.reverse();
  int info = 0;
  if (n > 0) dlauum_("U", &n, work.data(), &n, &info, 1);
  double* next = to.data();
  for (int j = 0; j < n; ++j)
    for (int i = j; i < n; ++i) *next++ = work(n - 1 - i, n - 1 - j);
}

} // namespace

EliminationOrder order_of_halves(const Graph& graph, Ordering ordering, Ranks& both) {
  std::vector<int> part = halves_and_separator(graph);
  both.broadcast(part.data(), sizeof(int) * part.size(), 0);
  std::vector<int> members[3], place(part.size());
  for (std::size_t v = 0; v < part.size(); ++v) {
    place[v] = static_cast<int>(members[part[v]].size());
    members[part[v]].push_back(static_cast<int>(v));
  }
  Graph half;
  const std::vector<int> own = members[both.rank()];
  for (const int v : own) {
    for (int k = graph.row_start[v]; k < graph.row_start[v + 1]; ++k)
      if (part[graph.col[k]] == both.rank()) half.col.push_back(place[graph.col[k]]);
    half.row_start.push_back(static_cast<int>(half.col.size()));
  }
  const std::vector<int> order = fill_reducing_order(half, ordering);
  for (std::size_t k = 0; k < order.size(); ++k) members[both.rank()][k] = own[order[k]];
  EliminationOrder all;
  for (const int r : {0, 1, SEPARATOR}) {
    if (r != SEPARATOR) {
      both.broadcast(members[r].data(), sizeof(int) * members[r].size(), r);
      all.halves[r] = static_cast<int>(members[r].size());
    }
    all.order.insert(all.order.end(), members[r].begin(), members[r].end());
  }
  return all;
}

// Columns of the own half and of t, both without a gap; of unknowns that are left out or moved to the end comes no fill.
void HalvedFactor::analyze(std::vector<int> col_start, std::vector<int> row, int first) {
  m_analyzed = m_factorized = false;
  m_size = static_cast<int>(col_start.size()) - 1;
  if (num_top() < 0 || (first >= 0 && first < m_size - num_top()))
    throw std::logic_error("HalvedFactor::analyze: the halves are more than what comes first");
  const int begin = begin_of(m_ranks.rank()), end = begin + own_half(), top = m_size - num_top();
  m_half_entries = {static_cast<std::size_t>(col_start[begin]), static_cast<std::size_t>(col_start[end])};
  m_top_entries = {static_cast<std::size_t>(col_start[top]), row.size()};
  std::vector<int> start{0}, rows;
  m_top_row.clear();
  m_top_column.clear();
  const auto append_column = [&](int j) {
    for (int k = col_start[j]; k < col_start[j + 1]; ++k) {
      if (row[k] >= end && row[k] < top) throw std::logic_error("HalvedFactor::analyze: the halves touch");
      rows.push_back(row[k] - (row[k] < top ? begin : top - own_half()));
      if (j < top) continue;
      m_top_row.push_back(row[k] - top);
      m_top_column.push_back(j - top);
    }
    start.push_back(static_cast<int>(rows.size()));
  };
  for (int j = begin; j < end; ++j) append_column(j);
  for (int j = top; j < m_size; ++j) append_column(j);
  m_own.analyze(std::move(start), std::move(rows));
  double entries = static_cast<double>(m_own.factor_entries());
  add_up(&entries, 1);
  m_entries = static_cast<std::size_t>(entries);
  m_analyzed = true;
}

bool HalvedFactor::all_well(bool here) const { return m_ranks.least(here ? 1 : 0) == 1; }

// Own numbers become the sum of both ranks', in the same order on both.
void HalvedFactor::add_up(double* own, std::size_t n) const {
  m_exchange.resize(std::max(m_exchange.size(), 2 * n));
  std::copy(own, own + n, m_exchange.begin() + n * m_ranks.rank());
  m_ranks.gather(m_exchange.data(), {0, n, 2 * n});
  for (std::size_t k = 0; k < n; ++k) own[k] = m_exchange[k] + m_exchange[n + k];
}

// In place of the last one: new pages of memory take as long as the sums.
void HalvedFactor::form_schur_complement(const std::vector<double>& values) {
  const std::size_t n = num_top();
  m_packed.resize(n * (n + 1) / 2);
  packed_product(m_own_top, m_schur, m_packed);
  add_up(m_packed.data(), m_packed.size());
  const double* from = m_packed.data();
  for (int j = 0; j < num_top(); ++j)
    for (int i = j; i < num_top(); ++i) m_schur(i, j) = *from++;
  for (std::size_t k = 0; k < m_top_row.size(); ++k)
    m_schur(m_top_row[k], m_top_column[k]) -= values[m_top_entries[0] + k];
}

FactorStatus HalvedFactor::factorize(std::vector<double> values) {
  if (!m_analyzed) throw std::logic_error("HalvedFactor::factorize: call analyze first");
  if (values.size() != m_top_entries[1])
    throw std::logic_error("HalvedFactor::factorize: not as many values as rows of analyze");
  m_factorized = false;
  std::vector<double> own(values.begin() + m_half_entries[0], values.begin() + m_half_entries[1]);
  own.insert(own.end(), values.begin() + m_top_entries[0], values.end());
  if (!all_well(m_own.factorize(std::move(own)) == FactorStatus::OK))
    return FactorStatus::NOT_POSITIVE_DEFINITE;
  m_own_top = m_own.trailing_factor(own_half());
  form_schur_complement(values);
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
  auto half = b.middleRows(begin_of(m_ranks.rank()), own_half());
  Eigen::MatrixXd y = Eigen::MatrixXd::Zero(m_own.size(), b.cols());
  y.topRows(own_half()) = half;
  m_own.solve_lower(y);
  half = y.topRows(own_half());
  Eigen::MatrixXd change(num_top(), b.cols());
  for (Eigen::Index c = 0; c < b.cols(); ++c) // of one column Eigen makes no copy of the triangle
    change.col(c) = m_own_top.triangularView<Eigen::Lower>() * y.col(c).tail(num_top());
  add_up(change.data(), change.size());
  auto top = b.bottomRows(num_top());
  top += change;
  for (auto column : top.colwise()) m_schur.triangularView<Eigen::Lower>().solveInPlace(column);
}

// x_t, then x_h = L_hh'^-1 (y_h - L_th' x_t) of both ranks.
void HalvedFactor::solve_upper(Eigen::Ref<Eigen::MatrixXd> b) const {
  require_factor("HalvedFactor::solve_upper", b.rows());
  if (b.size() == 0) return;
  auto top = b.bottomRows(num_top());
  for (auto column : top.colwise()) m_schur.triangularView<Eigen::Lower>().transpose().solveInPlace(column);
  Eigen::MatrixXd x(m_own.size(), b.cols());
  x.topRows(own_half()) = b.middleRows(begin_of(m_ranks.rank()), own_half());
  for (Eigen::Index c = 0; c < b.cols(); ++c)
    x.col(c).tail(num_top()) = m_own_top.triangularView<Eigen::Lower>().transpose() * top.col(c);
  m_own.solve_upper(x);
  const std::size_t cols = b.cols(), first = m_halves[0] * cols, all = first + m_halves[1] * cols;
  std::vector<double> both(all);
  const auto of = [&](int r) {
    return Eigen::Map<Eigen::MatrixXd>(both.data() + (r == 0 ? 0 : first), m_halves[r], b.cols());
  };
  of(m_ranks.rank()) = x.topRows(own_half());
  m_ranks.gather(both.data(), {0, first, all});
  for (int r : {0, 1}) b.middleRows(begin_of(r), m_halves[r]) = of(r);
}

void HalvedFactor::solve(Eigen::Ref<Eigen::MatrixXd> b) const {
  solve_lower(b);
  solve_upper(b);
}

Eigen::MatrixXd HalvedFactor::trailing_factor(int first) const {
  require_factor("HalvedFactor::trailing_factor", m_size);
  const int count = m_size - first;
  if (count < 0 || count > num_top())
    throw std::logic_error("HalvedFactor::trailing_factor: not the first of analyze");
  Eigen::MatrixXd block = m_schur.bottomRightCorner(count, count).triangularView<Eigen::Lower>();
  return block;
}

} // namespace burnish
