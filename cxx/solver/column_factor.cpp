#include "solver/column_factor.hpp"
#include "base/error.hpp"
#include "solver/asymmetry.hpp"
#include "solver/free_rows.hpp"
#include <cmath>

namespace burnish {
namespace {

constexpr double SOLVED = 1e-3; // residual over the right-hand side: beyond, the solver has not solved it
constexpr double SYMMETRIC =
    1e-10; // largest |k_ij - k_ji| over the largest entry of a matrix that counts as symmetric
constexpr Eigen::Index FIRST_COLUMNS = 32; // that there is room for at first
constexpr int MOST_TURNS = 12;             // of the inverse iteration that looks for a negative eigenvalue
constexpr double GROWS = 1.1;              // it has settled where the softness found grows by less a turn

} // namespace

template <int Dim> struct ColumnFactor<Dim>::Impl {
  std::unique_ptr<SparseSolver> solver;
  std::vector<int> row_start, col; // the node pattern analyzed
  std::vector<char> fixed;
  std::vector<int> candidates;
  FreeRows<Dim> rows;
  bool symmetric = true, has_factor = false;
  int analyses = 0;
  long solved_columns = 0;
  std::unique_ptr<HalfColumns> halves;   // of a factor that can be read; else:
  Eigen::MatrixXd columns;               // of K^-1 over the free dofs, the first known.size()
  std::shared_ptr<Eigen::MatrixXd> C;    // over the known dofs, and room for more
  std::vector<int> number;               // per dof: its column, -1: not known
  std::vector<int> known;                // dofs by columns
  std::vector<std::vector<int>> calls;   // the same by calls
  Eigen::VectorXd last_weight, last_sum; // of combined()

  FactorStatus tried();
  Eigen::VectorXd solve_free(Eigen::VectorXd b) const;
  void know(const std::vector<int>& dofs);
  void solve_for(const std::vector<int>& dofs);
  const Eigen::VectorXd& combined(const Eigen::VectorXd& p, const char* where);
  int dof_of(int component) const { return Dim * candidates[component / Dim] + component % Dim; }
  void require_factor(const char* where) const {
    if (!has_factor) fail(where, "there is no factor, call factorize first");
  }
};

// A right-hand side without symmetry, and its solution as the next one: softest motions come out of an inverse iteration, a
// negative one among them, too. Goes on until the softness found hardly grows.
template <int Dim> FactorStatus ColumnFactor<Dim>::Impl::tried() {
  const FactorStatus refused =
      solver->symmetric() ? FactorStatus::NOT_POSITIVE_DEFINITE : FactorStatus::SINGULAR;
  Eigen::VectorXd b(rows.size());
  for (int i = 0; i < rows.size(); ++i) b[i] = std::sin(1. + 7. * i);
  double softness = 0;
  for (int turn = 0; turn < MOST_TURNS; ++turn) {
    const Eigen::VectorXd x = solve_free(b);
    if (!x.allFinite() || !((rows.product(x) - b).norm() <= SOLVED * b.norm())) return refused;
    if (symmetric && b.dot(x) < 0) return FactorStatus::NOT_POSITIVE_DEFINITE;
    const double before = softness;
    softness = x.norm() / b.norm();
    if (turn > 0 && softness < GROWS * before) break;
    b = x.normalized();
  }
  return FactorStatus::OK;
}

template <int Dim> Eigen::VectorXd ColumnFactor<Dim>::Impl::solve_free(Eigen::VectorXd b) const {
  Eigen::MatrixXd x = std::move(b);
  solver->solve(x);
  return x;
}

// Columns for these dofs, those of them that are free and not known yet.
template <int Dim> void ColumnFactor<Dim>::Impl::know(const std::vector<int>& dofs) {
  std::vector<int> fresh, at;
  for (const int d : dofs)
    if (rows.row_of(d) >= 0 && number[d] < 0) {
      number[d] = static_cast<int>(known.size() + fresh.size());
      fresh.push_back(d);
      at.push_back(rows.row_of(d));
    }
  if (fresh.empty()) return;
  known.insert(known.end(), fresh.begin(), fresh.end());
  const auto needed = static_cast<Eigen::Index>(known.size());
  if (C->rows() < needed) {
    const Eigen::Index room = std::max(FIRST_COLUMNS, needed + needed / 2);
    Eigen::MatrixXd larger = Eigen::MatrixXd::Zero(room, room);
    larger.topLeftCorner(C->rows(), C->cols()) = *C;
    *C = std::move(larger);
  }
  if (halves)
    halves->append(at, *C);
  else
    solve_for(fresh);
  calls.push_back(fresh);
  solved_columns += static_cast<long>(fresh.size());
}

// The last known dofs, by the solver, in one call.
template <int Dim> void ColumnFactor<Dim>::Impl::solve_for(const std::vector<int>& dofs) {
  const auto count = static_cast<Eigen::Index>(dofs.size()), needed = static_cast<Eigen::Index>(known.size());
  Eigen::MatrixXd B = Eigen::MatrixXd::Zero(rows.size(), count);
  for (Eigen::Index j = 0; j < count; ++j) B(rows.row_of(dofs[j]), j) = 1;
  solver->solve(B);
  if (columns.rows() != rows.size() || columns.cols() < needed)
    columns.conservativeResize(rows.size(), C->cols());
  columns.middleCols(needed - count, count) = B;
  for (Eigen::Index j = needed - count; j < needed; ++j)
    for (Eigen::Index i = 0; i < needed; ++i) {
      (*C)(i, j) = columns(rows.row_of(known[i]), j);
      (*C)(j, i) = columns(rows.row_of(known[j]), i);
    }
}

// K^-1 p over the free dofs, of a load on the candidates; the last one is kept.
template <int Dim>
const Eigen::VectorXd& ColumnFactor<Dim>::Impl::combined(const Eigen::VectorXd& p, const char* where) {
  require(static_cast<std::size_t>(p.size()) == Dim * candidates.size(), where, "p.size()", p.size(),
          "Dim*candidates");
  std::vector<int> loaded;
  for (Eigen::Index i = 0; i < p.size(); ++i)
    if (p[i] != 0) loaded.push_back(dof_of(static_cast<int>(i)));
  know(loaded);
  Eigen::VectorXd weight = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(known.size()));
  for (Eigen::Index i = 0; i < p.size(); ++i) {
    const int column = number[dof_of(static_cast<int>(i))];
    if (column >= 0) weight[column] = p[i];
  }
  if (last_weight.size() == weight.size() && last_weight == weight && last_sum.size() == rows.size())
    return last_sum;
  last_weight = weight;
  if (halves)
    last_sum = solver->second_half(halves->sum(weight));
  else {
    last_sum = Eigen::VectorXd::Zero(rows.size());
    for (Eigen::Index j = 0; j < weight.size(); ++j)
      if (weight[j] != 0) last_sum += weight[j] * columns.col(j);
  }
  return last_sum;
}

template <int Dim>
ColumnFactor<Dim>::ColumnFactor(std::unique_ptr<SparseSolver> solver) : m_impl(std::make_unique<Impl>()) {
  m_impl->solver = std::move(solver);
}
template <int Dim> ColumnFactor<Dim>::~ColumnFactor() = default;

template <int Dim>
void ColumnFactor<Dim>::analyze(const NodeBlockMatrix<Dim>& pattern, const std::vector<char>& fixed,
                                const std::vector<int>& candidates) {
  const char* where = "ColumnFactor::analyze";
  Impl& impl = *m_impl;
  require(static_cast<int>(fixed.size()) == pattern.size(), where, "fixed.size()", fixed.size(),
          "Dim*num_nodes");
  for (const int node : candidates)
    require(node >= 0 && node < pattern.num_nodes, where, "candidate", node, "a node of the matrix");
  impl.candidates = candidates;
  const bool same = impl.analyses > 0 && pattern.row_start == impl.row_start && pattern.col == impl.col &&
                    fixed == impl.fixed;
  if (same) return;
  impl.has_factor = false;
  impl.row_start = pattern.row_start;
  impl.col = pattern.col;
  impl.fixed = fixed;
  impl.rows = FreeRows<Dim>(pattern, fixed, impl.solver->symmetric());
  SparsePattern(where, impl.rows.view()); // refuses one that is empty or not sorted
  impl.solver->analyze(impl.rows.view());
  ++impl.analyses;
}

template <int Dim>
FactorStatus ColumnFactor<Dim>::factorize(NodeBlockMatrix<Dim> matrix, const Eigen::VectorXd& added) {
  const char* where = "ColumnFactor::factorize";
  Impl& impl = *m_impl;
  impl.has_factor = false;
  if (impl.analyses == 0 || matrix.row_start != impl.row_start || matrix.col != impl.col)
    fail(where, "the matrix has not the pattern analyzed, call analyze first");
  require(added.size() == 0 || static_cast<std::size_t>(added.size()) == Dim * impl.candidates.size(), where,
          "added.size()", added.size(), "Dim*candidates or 0");
  impl.rows.take_values(matrix);
  matrix = {};
  for (Eigen::Index i = 0; i < added.size(); ++i)
    if (const int at = impl.rows.row_of(impl.dof_of(static_cast<int>(i))); at >= 0)
      impl.rows.add_to_diagonal(at, added[i]);
  check_values(where, impl.rows.view());
  impl.symmetric = largest_asymmetry(impl.rows.view()) <= SYMMETRIC;
  impl.number.assign(impl.fixed.size(), -1);
  impl.known.clear();
  impl.calls.clear();
  impl.halves.reset();
  impl.last_sum.resize(0);
  impl.C = std::make_shared<Eigen::MatrixXd>();
  if (!impl.solver->factorize(impl.rows.view().value))
    return impl.solver->symmetric() ? FactorStatus::NOT_POSITIVE_DEFINITE : FactorStatus::SINGULAR;
  const FactorStatus status = impl.tried();
  impl.has_factor = status == FactorStatus::OK;
  if (impl.has_factor) impl.halves = impl.solver->half_columns();
  return status;
}

template <int Dim> Eigen::VectorXd ColumnFactor<Dim>::solve(const Eigen::VectorXd& b) const {
  return sweep(b).y;
}

template <int Dim> SweptLoad ColumnFactor<Dim>::sweep(const Eigen::VectorXd& b) const {
  const char* where = "ColumnFactor::sweep";
  m_impl->require_factor(where);
  return {m_impl->rows.scattered(m_impl->solve_free(m_impl->rows.gathered(b, where)))};
}

template <int Dim> Eigen::VectorXd ColumnFactor<Dim>::candidate_displacement(const SweptLoad& load) const {
  Eigen::VectorXd u(Dim * static_cast<Eigen::Index>(m_impl->candidates.size()));
  for (Eigen::Index i = 0; i < u.size(); ++i) u[i] = load.y[m_impl->dof_of(static_cast<int>(i))];
  return u;
}

template <int Dim>
Eigen::VectorXd ColumnFactor<Dim>::displacement(const SweptLoad& load, const Eigen::VectorXd& p) const {
  const char* where = "ColumnFactor::displacement";
  m_impl->require_factor(where);
  if (!p.allFinite()) fail(where, "p is not finite, expected finite numbers");
  return load.y + m_impl->rows.scattered(m_impl->combined(p, where));
}

template <int Dim> Eigen::VectorXd ColumnFactor<Dim>::displacement_under(const Eigen::VectorXd& p) const {
  const char* where = "ColumnFactor::displacement_under";
  m_impl->require_factor(where);
  return candidate_displacement({m_impl->rows.scattered(m_impl->combined(p, where))});
}

template <int Dim> std::shared_ptr<const Eigen::MatrixXd> ColumnFactor<Dim>::candidate_flexibility() const {
  m_impl->require_factor("ColumnFactor::candidate_flexibility");
  return m_impl->C;
}

template <int Dim>
std::vector<int> ColumnFactor<Dim>::complete_flexibility(const std::vector<int>& components) const {
  const char* where = "ColumnFactor::complete_flexibility";
  m_impl->require_factor(where);
  std::vector<int> dofs;
  for (const int i : components) {
    dofs.push_back(m_impl->dof_of(i));
    require(m_impl->rows.row_of(dofs.back()) >= 0, where, "component", i, "a free one");
  }
  m_impl->know(dofs);
  for (int& d : dofs) d = m_impl->number[d];
  return dofs;
}

template <int Dim> std::size_t ColumnFactor<Dim>::factor_entries() const {
  return m_impl->solver->factor_entries();
}

template <int Dim> std::vector<std::vector<int>> ColumnFactor<Dim>::solved_columns() const {
  return m_impl->calls;
}
template <int Dim> void ColumnFactor<Dim>::solve_columns(const std::vector<std::vector<int>>& calls) {
  for (const auto& dofs : calls) m_impl->know(dofs);
}

template <int Dim> bool ColumnFactor<Dim>::symmetric() const { return m_impl->symmetric; }
template <int Dim> int ColumnFactor<Dim>::analyses() const { return m_impl->analyses; }
template <int Dim> long ColumnFactor<Dim>::columns() const { return m_impl->solved_columns; }

template class ColumnFactor<2>;
template class ColumnFactor<3>;

} // namespace burnish
