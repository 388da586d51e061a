#include "solver/schur_factor.hpp"
#include "base/dense_kernels.hpp"
#include "base/error.hpp"
#include "solver/ordered_factor.hpp"
#include "solver/permuted_triangle.hpp"
#include <cmath>
#include <utility>

namespace burnish {

template <int Dim> struct SchurFactor<Dim>::Impl {
  std::vector<int> row_start, col; // the pattern analyzed, with the flags and candidates of that time
  std::vector<char> fixed;
  std::vector<int> candidates;
  PermutedTriangle triangle;
  std::unique_ptr<OrderedFactor> factor;
  Eigen::MatrixXd trailing; // L of the candidates
  int analyses = 0, factorizations = 0, solves = 0;

  bool is_analyzed(const NodeBlockMatrix<Dim>& pattern) const {
    return analyses > 0 && pattern.row_start == row_start && pattern.col == col;
  }
  void require_factor(const char* where) const {
    if (!factor || !factor->is_factorized()) fail(where, "there is no factor, call factorize first");
  }
  std::vector<double> values_of(const NodeBlockMatrix<Dim>& matrix) const; // in the order of the triangle
  [[noreturn]] void report_not_finite(const NodeBlockMatrix<Dim>& matrix) const;
  void require_swept(const SweptLoad& load, const char* where) const {
    require_factor(where);
    require(static_cast<std::size_t>(load.y.size()) == triangle.order.size(), where, "size of the swept load",
            load.y.size(), "that of the factor");
  }
  Eigen::VectorXd permuted(const Eigen::VectorXd& b,
                           const char* where) const; // checked, in the order of elimination
  Eigen::VectorXd on_nodes(const Eigen::VectorXd& y) const;
  std::vector<int> free_candidate_dofs() const;
  Eigen::MatrixXd with_fixed_dofs(const Eigen::MatrixXd& free, double diagonal) const;
};

template <int Dim>
std::vector<double> SchurFactor<Dim>::Impl::values_of(const NodeBlockMatrix<Dim>& matrix) const {
  const std::vector<std::uint32_t>& slot = triangle.slot;
  std::vector<double> value(slot.size());
  double check = 0; // stays zero unless a value is not finite
  for (std::size_t k = 0; k < slot.size(); ++k) {
    value[k] = matrix.value[slot[k]];
    check += 0. * value[k];
  }
  if (check != 0.) report_not_finite(matrix);
  return value;
}

template <int Dim> void SchurFactor<Dim>::Impl::report_not_finite(const NodeBlockMatrix<Dim>& matrix) const {
  for (int node = 0; node < matrix.num_nodes; ++node) {
    for (int k = matrix.row_start[node]; k < matrix.row_start[node + 1]; ++k) {
      for (int i = 0; i < Dim * Dim; ++i) {
        const int row = Dim * node + i / Dim, column = Dim * matrix.col[k] + i % Dim;
        const double value = matrix.block(k)[i];
        if (row < column || fixed[row] || fixed[column] || std::isfinite(value)) continue;
        std::ostringstream what;
        what << "value of entry (row " << row << ", column " << column << ") = " << value
             << ", expected a finite number";
        fail("SchurFactor::factorize", what.str());
      }
    }
  }
  throw std::logic_error("SchurFactor::factorize: a value is not finite, its place was not found");
}

/// Those of the trailing block, numbered among all candidate dofs.
template <int Dim> std::vector<int> SchurFactor<Dim>::Impl::free_candidate_dofs() const {
  std::vector<int> place;
  for (int i = 0; i < Dim * static_cast<int>(candidates.size()); ++i)
    if (!fixed[Dim * candidates[i / Dim] + i % Dim]) place.push_back(i);
  return place;
}

/// Puts the matrix of the free candidate dofs among all candidate dofs; fixed ones get the given diagonal.
template <int Dim>
Eigen::MatrixXd SchurFactor<Dim>::Impl::with_fixed_dofs(const Eigen::MatrixXd& free, double diagonal) const {
  const int size = Dim * static_cast<int>(candidates.size());
  const std::vector<int> place = free_candidate_dofs();
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(size, size);
  all.diagonal().setConstant(diagonal);
  for (std::size_t j = 0; j < place.size(); ++j)
    for (std::size_t i = 0; i < place.size(); ++i) all(place[i], place[j]) = free(i, j);
  return all;
}

template <int Dim> SchurFactor<Dim>::SchurFactor() : m_impl(std::make_unique<Impl>()) {}
template <int Dim> SchurFactor<Dim>::~SchurFactor() = default;
template <int Dim> SchurFactor<Dim>::SchurFactor(SchurFactor&&) noexcept = default;
template <int Dim> SchurFactor<Dim>& SchurFactor<Dim>::operator=(SchurFactor&&) noexcept = default;

// Only the counts stay.
template <int Dim> void SchurFactor<Dim>::release() {
  Impl empty;
  empty.analyses = m_impl->analyses;
  empty.factorizations = m_impl->factorizations;
  empty.solves = m_impl->solves;
  *m_impl = std::move(empty);
}

template <int Dim>
void SchurFactor<Dim>::analyze(const NodeBlockMatrix<Dim>& pattern, const std::vector<char>& fixed,
                               const std::vector<int>& candidates) {
  if (m_impl->is_analyzed(pattern) && fixed == m_impl->fixed && candidates == m_impl->candidates) return;
  require_permutable(pattern, fixed, candidates); // a refusal leaves the analysis as it was
  Impl fresh;
  fresh.analyses = m_impl->analyses + 1;
  fresh.factorizations = m_impl->factorizations;
  fresh.solves = m_impl->solves;
  release(); // two factors at a time are never held
  fresh.triangle = permute_candidates_last(pattern, fixed, candidates);
  fresh.factor =
      make_ordered_factor(static_cast<int>(fresh.triangle.order.size()), Dim, fresh.triangle.halves);
  fresh.factor->analyze(std::move(fresh.triangle.col_start), std::move(fresh.triangle.row),
                        fresh.triangle.num_interior);
  fresh.row_start = pattern.row_start;
  fresh.col = pattern.col;
  fresh.fixed = fixed;
  fresh.candidates = candidates;
  *m_impl = std::move(fresh);
}

template <int Dim>
FactorStatus SchurFactor<Dim>::factorize(NodeBlockMatrix<Dim> matrix, const Eigen::VectorXd& added) {
  const char* where = "SchurFactor::factorize";
  if (!m_impl->is_analyzed(matrix))
    fail(where, "the matrix has not the pattern analyzed, call analyze first");
  require(matrix.value.size() == matrix.col.size() * Dim * Dim, where, "value.size()", matrix.value.size(),
          "Dim*Dim per block");
  require(added.size() == 0 || static_cast<std::size_t>(added.size()) == Dim * m_impl->candidates.size(),
          where, "added.size()", added.size(), "Dim*candidates or 0");
  std::vector<double> values = m_impl->values_of(matrix);
  matrix = {};
  if (added.size() > 0) {
    const std::vector<int> free = m_impl->free_candidate_dofs();
    for (std::size_t i = 0; i < free.size(); ++i) values[m_impl->triangle.diagonal[i]] += added[free[i]];
  }
  ++m_impl->factorizations;
  const FactorStatus status = m_impl->factor->factorize(std::move(values));
  if (status == FactorStatus::OK)
    m_impl->trailing = m_impl->factor->trailing_factor(m_impl->triangle.num_interior);
  return status;
}

template <int Dim>
Eigen::VectorXd SchurFactor<Dim>::Impl::permuted(const Eigen::VectorXd& b, const char* where) const {
  require(static_cast<std::size_t>(b.size()) == fixed.size(), where, "b.size()", b.size(), "Dim*num_nodes");
  Eigen::VectorXd y(static_cast<Eigen::Index>(triangle.order.size()));
  for (std::size_t p = 0; p < triangle.order.size(); ++p) {
    y[p] = b[triangle.order[p]];
    if (!std::isfinite(y[p]))
      fail(where, "b[" + std::to_string(triangle.order[p]) + "] is not finite, expected finite numbers");
  }
  return y;
}

template <int Dim> Eigen::VectorXd SchurFactor<Dim>::Impl::on_nodes(const Eigen::VectorXd& y) const {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(fixed.size()));
  for (std::size_t p = 0; p < triangle.order.size(); ++p) x[triangle.order[p]] = y[p];
  return x;
}

template <int Dim> Eigen::VectorXd SchurFactor<Dim>::solve(const Eigen::VectorXd& b) const {
  m_impl->require_factor("SchurFactor::solve");
  Eigen::VectorXd y = m_impl->permuted(b, "SchurFactor::solve");
  m_impl->factor->solve(y);
  ++m_impl->solves;
  return m_impl->on_nodes(y);
}

template <int Dim> SweptLoad SchurFactor<Dim>::sweep(const Eigen::VectorXd& b) const {
  m_impl->require_factor("SchurFactor::sweep");
  SweptLoad load{m_impl->permuted(b, "SchurFactor::sweep")};
  m_impl->factor->solve_lower(load.y);
  return load;
}

template <int Dim> Eigen::VectorXd SchurFactor<Dim>::candidate_displacement(const SweptLoad& load) const {
  m_impl->require_swept(load, "SchurFactor::candidate_displacement");
  const std::vector<int> free = m_impl->free_candidate_dofs();
  Eigen::VectorXd y = load.y.tail(static_cast<Eigen::Index>(free.size()));
  m_impl->trailing.transpose().template triangularView<Eigen::Upper>().solveInPlace(y);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(Dim * static_cast<Eigen::Index>(m_impl->candidates.size()));
  for (std::size_t k = 0; k < free.size(); ++k) u[free[k]] = y[static_cast<Eigen::Index>(k)];
  return u;
}

template <int Dim>
Eigen::VectorXd SchurFactor<Dim>::displacement(const SweptLoad& load, const Eigen::VectorXd& p) const {
  const char* where = "SchurFactor::displacement";
  m_impl->require_swept(load, where);
  require(static_cast<std::size_t>(p.size()) == Dim * m_impl->candidates.size(), where, "p.size()", p.size(),
          "Dim*candidates");
  if (!p.allFinite()) fail(where, "p is not finite, expected finite numbers");
  const std::vector<int> free = m_impl->free_candidate_dofs();
  Eigen::VectorXd more(static_cast<Eigen::Index>(free.size())), y = load.y;
  for (std::size_t k = 0; k < free.size(); ++k) more[static_cast<Eigen::Index>(k)] = p[free[k]];
  m_impl->trailing.template triangularView<Eigen::Lower>().solveInPlace(more);
  y.tail(more.size()) += more;
  m_impl->factor->solve_upper(y);
  ++m_impl->solves;
  return m_impl->on_nodes(y);
}

template <int Dim> std::shared_ptr<const Eigen::MatrixXd> SchurFactor<Dim>::candidate_flexibility() const {
  m_impl->require_factor("SchurFactor::candidate_flexibility");
  const Eigen::MatrixXd inverse = inverse_from_cholesky(m_impl->trailing, m_impl->trailing.rows());
  return std::make_shared<const Eigen::MatrixXd>(m_impl->with_fixed_dofs(inverse, 0.));
}

template <int Dim> Eigen::MatrixXd SchurFactor<Dim>::schur_complement() const {
  m_impl->require_factor("SchurFactor::schur_complement");
  const Eigen::MatrixXd& lower = m_impl->trailing;
  Eigen::MatrixXd schur = Eigen::MatrixXd::Zero(lower.rows(), lower.cols());
  schur.selfadjointView<Eigen::Lower>().rankUpdate(lower);
  schur.triangularView<Eigen::StrictlyUpper>() = schur.transpose();
  return m_impl->with_fixed_dofs(schur, 1.);
}

template <int Dim> std::size_t SchurFactor<Dim>::factor_entries() const {
  return m_impl->factor ? m_impl->factor->factor_entries() : 0;
}
template <int Dim> int SchurFactor<Dim>::analyses() const { return m_impl->analyses; }
template <int Dim> int SchurFactor<Dim>::factorizations() const { return m_impl->factorizations; }
template <int Dim> int SchurFactor<Dim>::solves() const { return m_impl->solves; }

template class SchurFactor<2>;
template class SchurFactor<3>;

} // namespace burnish
