#include "solver/bordered_solver.hpp"
#include "base/error.hpp"
#include "solver/asymmetry.hpp"
#include "solver/cholmod_factor.hpp"
#include "solver/fill_ordering.hpp"
#include <algorithm>
#include <limits>
#include <utility>

namespace burnish {

namespace {

constexpr double SYMMETRY_TOLERANCE = 1e-14; // relative to the rows' largest entries, rounding of an assembly
constexpr int PANEL = 32;                    // columns of E solved for at a time

/// Sparse coupling of one border index with the rest: position in the permuted rest and place in the values.
struct Coupling {
  int rest = 0;
  int slot = 0;
};

} // namespace

struct BorderedSolver::Impl {
  int max_border;
  SparsePattern pattern;
  bool has_border = false;
  bool has_factor = false;
  int analyses = 0;
  std::vector<int> border;    // ascending
  std::vector<int> order;     // of elimination in the rest
  std::vector<int> place;     // per index: position in `order`, or -1 - position in `border`
  std::vector<int> rest_slot; // per entry of the lower triangle of B
  std::vector<std::vector<Coupling>> column, row; // E by columns, F by rows
  std::vector<double> value;
  CholmodFactor factor;
  Eigen::VectorXd row_scale; // rows of S are divided by it before the LU
  Eigen::PartialPivLU<Eigen::MatrixXd> schur;

  explicit Impl(int max) : max_border(max) {}
  bool covers(const std::vector<std::pair<int, int>>& pairs) const;
  FactorStatus choose_border(const SparseView& matrix);
  void analyze(std::vector<int> new_border);
  void order_rest();
  void distribute_entries();
  Eigen::MatrixXd border_block() const;
  FactorStatus factorize_schur();
  Eigen::VectorXd solve(const char* where, const Eigen::VectorXd& b, bool transposed) const;
};

/// The border contains one of every pair.
bool BorderedSolver::Impl::covers(const std::vector<std::pair<int, int>>& pairs) const {
  return std::all_of(pairs.begin(), pairs.end(),
                     [&](const auto& pair) { return place[pair.first] < 0 || place[pair.second] < 0; });
}

/// Keeps the border if it serves and is at most twice as large as needed, else analyzes for a new one.
FactorStatus BorderedSolver::Impl::choose_border(const SparseView& matrix) {
  const auto pairs = asymmetric_pairs(pattern, matrix, SYMMETRY_TOLERANCE);
  std::vector<int> cover = greedy_cover(pattern.n, pairs, max_border);
  if (static_cast<int>(cover.size()) > max_border) {
    has_border = false;
    border.clear();
    return FactorStatus::BORDER_TOO_LARGE;
  }
  if (!has_border || !covers(pairs) || border.size() > 2 * cover.size()) analyze(std::move(cover));
  return FactorStatus::OK;
}

void BorderedSolver::Impl::analyze(std::vector<int> new_border) {
  has_border = false;
  border = std::move(new_border);
  place.assign(pattern.n, 0);
  for (std::size_t b = 0; b < border.size(); ++b) place[border[b]] = -1 - static_cast<int>(b);
  order_rest();
  distribute_entries();
  has_border = true;
  ++analyses;
}

void BorderedSolver::Impl::order_rest() {
  std::vector<int> rest, local(pattern.n, -1);
  for (int i = 0; i < pattern.n; ++i) {
    if (place[i] < 0) continue;
    local[i] = static_cast<int>(rest.size());
    rest.push_back(i);
  }
  Graph graph;
  for (int i : rest) {
    for (int k = pattern.row_start[i]; k < pattern.row_start[i + 1]; ++k)
      if (local[pattern.col[k]] >= 0) graph.col.push_back(local[pattern.col[k]]);
    graph.row_start.push_back(static_cast<int>(graph.col.size()));
  }
  order.clear();
  for (int k : fill_reducing_order(graph, Ordering::AMD)) {
    place[rest[k]] = static_cast<int>(order.size());
    order.push_back(rest[k]);
  }
}

/// Every stored entry belongs to B (one of two mirrored ones is kept), E, F or D.
void BorderedSolver::Impl::distribute_entries() {
  column.assign(border.size(), {});
  row.assign(border.size(), {});
  std::vector<std::vector<Coupling>> lower(order.size()); // columns of the permuted lower triangle of B
  for (int i = 0; i < pattern.n; ++i) {
    for (int k = pattern.row_start[i]; k < pattern.row_start[i + 1]; ++k) {
      const int j = pattern.col[k], p = place[i], q = place[j];
      if (p >= 0 && q >= 0 && (j <= i || pattern.mirror[k] < 0))
        lower[std::min(p, q)].push_back({std::max(p, q), k});
      if (p >= 0 && q < 0) column[-1 - q].push_back({p, k});
      if (p < 0 && q >= 0) row[-1 - p].push_back({q, k});
    }
  }
  std::vector<int> col_start{0}, rows;
  rest_slot.clear();
  for (const auto& entries : lower) {
    for (const Coupling& entry : entries) {
      rows.push_back(entry.rest);
      rest_slot.push_back(entry.slot);
    }
    col_start.push_back(static_cast<int>(rows.size()));
  }
  factor.analyze(std::move(col_start), std::move(rows));
}

Eigen::MatrixXd BorderedSolver::Impl::border_block() const {
  Eigen::MatrixXd block = Eigen::MatrixXd::Zero(border.size(), border.size());
  for (std::size_t b = 0; b < border.size(); ++b)
    for (int k = pattern.row_start[border[b]]; k < pattern.row_start[border[b] + 1]; ++k)
      if (place[pattern.col[k]] < 0) block(b, -1 - place[pattern.col[k]]) = value[k];
  return block;
}

/// S = D - F (B^-1 E), some columns at a time so that B^-1 E is never stored.
FactorStatus BorderedSolver::Impl::factorize_schur() {
  Eigen::MatrixXd S = border_block();
  const int size = static_cast<int>(border.size());
  for (int first = 0; first < size; first += PANEL) {
    const int width = std::min(PANEL, size - first);
    Eigen::MatrixXd panel = Eigen::MatrixXd::Zero(order.size(), width);
    for (int c = 0; c < width; ++c)
      for (const Coupling& e : column[first + c]) panel(e.rest, c) = value[e.slot];
    factor.solve(panel);
    for (int b = 0; b < size; ++b)
      for (const Coupling& f : row[b]) S.row(b).segment(first, width) -= value[f.slot] * panel.row(f.rest);
  }
  row_scale = S.cwiseAbs().rowwise().maxCoeff();
  if (row_scale.minCoeff() == 0.) return FactorStatus::SINGULAR;
  schur.compute(row_scale.cwiseInverse().asDiagonal() * S);
  const double smallest = schur.matrixLU().diagonal().cwiseAbs().minCoeff();
  // the negated form also catches NaN
  if (!(smallest > 0. && schur.rcond() > std::numeric_limits<double>::epsilon()))
    return FactorStatus::SINGULAR;
  return FactorStatus::OK;
}

/// z = S^-1 (b_D - F B^-1 b_B), x_B = B^-1 (b_B - E z); transposed, E' and F' change places.
Eigen::VectorXd BorderedSolver::Impl::solve(const char* where, const Eigen::VectorXd& b,
                                            bool transposed) const {
  if (!has_factor) fail(where, "there is no factor, call factorize first");
  require(b.size() == pattern.n, where, "b.size()", b.size(), "n");
  if (!b.allFinite()) fail(where, "b is not finite, expected finite numbers");
  const auto &into = transposed ? column : row, &from = transposed ? row : column;
  Eigen::VectorXd rest(order.size()), z(border.size());
  for (std::size_t p = 0; p < order.size(); ++p) rest[p] = b[order[p]];
  if (!border.empty()) {
    Eigen::VectorXd y = rest;
    factor.solve(y);
    for (std::size_t k = 0; k < border.size(); ++k) {
      z[k] = b[border[k]];
      for (const Coupling& e : into[k]) z[k] -= value[e.slot] * y[e.rest];
    }
    if (transposed)
      z = schur.transpose().solve(z).eval().cwiseQuotient(row_scale);
    else
      z = schur.solve(z.cwiseQuotient(row_scale).eval()).eval();
    for (std::size_t k = 0; k < border.size(); ++k)
      for (const Coupling& e : from[k]) rest[e.rest] -= value[e.slot] * z[k];
  }
  factor.solve(rest);
  Eigen::VectorXd x(pattern.n);
  for (std::size_t p = 0; p < order.size(); ++p) x[order[p]] = rest[p];
  for (std::size_t k = 0; k < border.size(); ++k) x[border[k]] = z[k];
  return x;
}

BorderedSolver::BorderedSolver(int max_border) {
  require(max_border >= 0, "BorderedSolver", "max_border", max_border, "max_border >= 0");
  m_impl = std::make_unique<Impl>(max_border);
}
BorderedSolver::~BorderedSolver() = default;
BorderedSolver::BorderedSolver(BorderedSolver&&) noexcept = default;
BorderedSolver& BorderedSolver::operator=(BorderedSolver&&) noexcept = default;

FactorStatus BorderedSolver::factorize(const SparseView& matrix) {
  const char* where = "BorderedSolver::factorize";
  Impl& impl = *m_impl;
  impl.has_factor = false;
  if (!impl.pattern.matches(matrix)) {
    impl.has_border = false;
    impl.pattern = SparsePattern(where, matrix);
  }
  check_values(where, matrix);
  FactorStatus status = impl.choose_border(matrix);
  if (status != FactorStatus::OK) return status;
  impl.value.assign(matrix.value, matrix.value + impl.pattern.col.size());
  std::vector<double> rest(impl.rest_slot.size());
  for (std::size_t k = 0; k < rest.size(); ++k) rest[k] = impl.value[impl.rest_slot[k]];
  status = impl.factor.factorize(std::move(rest));
  if (status == FactorStatus::OK && !impl.border.empty()) status = impl.factorize_schur();
  impl.has_factor = status == FactorStatus::OK;
  return status;
}

Eigen::VectorXd BorderedSolver::solve(const Eigen::VectorXd& b) const {
  return m_impl->solve("BorderedSolver::solve", b, false);
}

Eigen::VectorXd BorderedSolver::solve_transposed(const Eigen::VectorXd& b) const {
  return m_impl->solve("BorderedSolver::solve_transposed", b, true);
}

int BorderedSolver::border_size() const { return static_cast<int>(m_impl->border.size()); }
int BorderedSolver::analyses() const { return m_impl->analyses; }

} // namespace burnish
