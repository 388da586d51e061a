#include "solver/cholmod_solver.hpp"
#include "solver/ordered_factor.hpp"
#include <algorithm>

namespace burnish {

struct CholmodSolver::Impl {
  int dim = 2; // of the body
  std::unique_ptr<OrderedFactor> factor;
  std::vector<int> place; // row of the matrix -> row of the factor
  std::vector<int> slot;  // per entry of the factor's triangle, that of the matrix

  // Column by column: Eigen permutes in place by rows, which takes a third of the time of the solve where columns are many.
  void permute(Eigen::MatrixXd& B, bool to_factor) const {
    Eigen::VectorXd column(B.rows());
    for (Eigen::Index j = 0; j < B.cols(); ++j) {
      column = B.col(j);
      for (std::size_t i = 0; i < place.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        B(to_factor ? place[i] : row, j) = column[to_factor ? row : place[i]];
      }
    }
  }
};

CholmodSolver::CholmodSolver(int dim) : m_impl(std::make_unique<Impl>()) { m_impl->dim = dim; }
CholmodSolver::~CholmodSolver() = default;

void CholmodSolver::analyze(const SparseView& pattern) {
  Graph graph;
  graph.row_start.assign(pattern.row_start, pattern.row_start + pattern.n + 1);
  graph.col.assign(pattern.col, pattern.col + graph.row_start.back());
  const auto [order, halves] = elimination_order(
      graph, m_impl->dim == 3 ? usual_ordering<3> : usual_ordering<2>, pattern.n, m_impl->dim);
  auto& place = m_impl->place;
  place.resize(pattern.n);
  for (int k = 0; k < pattern.n; ++k) place[order[k]] = k;
  std::vector<int> start(pattern.n + 1, 0), row(graph.col.size());
  const auto column = [&](int i, int k) { return std::min(place[i], place[graph.col[k]]); };
  for (int i = 0; i < pattern.n; ++i)
    for (int k = graph.row_start[i]; k < graph.row_start[i + 1]; ++k) ++start[column(i, k) + 1];
  for (int j = 0; j < pattern.n; ++j) start[j + 1] += start[j];
  std::vector<int> next(start.begin(), start.end() - 1);
  m_impl->slot.resize(row.size());
  for (int i = 0; i < pattern.n; ++i)
    for (int k = graph.row_start[i]; k < graph.row_start[i + 1]; ++k) {
      const int at = next[column(i, k)]++;
      row[at] = std::max(place[i], place[graph.col[k]]);
      m_impl->slot[at] = k;
    }
  m_impl->factor.reset(); // two factors at a time are never held
  m_impl->factor = make_ordered_factor(pattern.n, m_impl->dim, halves);
  m_impl->factor->analyze(std::move(start), std::move(row));
}

bool CholmodSolver::factorize(const double* value) {
  std::vector<double> permuted(m_impl->slot.size());
  for (std::size_t k = 0; k < permuted.size(); ++k) permuted[k] = value[m_impl->slot[k]];
  return m_impl->factor->factorize(std::move(permuted)) == FactorStatus::OK;
}

void CholmodSolver::solve(Eigen::MatrixXd& B) {
  m_impl->permute(B, true);
  m_impl->factor->solve(B);
  m_impl->permute(B, false);
}

std::unique_ptr<HalfColumns> CholmodSolver::half_columns() const {
  const auto L = m_impl->factor->supernodes();
  return L ? std::make_unique<HalfColumns>(*L, m_impl->place) : nullptr;
}

Eigen::VectorXd CholmodSolver::second_half(Eigen::VectorXd y) const {
  m_impl->factor->solve_upper(y);
  return y(m_impl->place);
}

std::size_t CholmodSolver::factor_entries() const {
  return m_impl->factor ? m_impl->factor->factor_entries() : 0;
}

} // namespace burnish
