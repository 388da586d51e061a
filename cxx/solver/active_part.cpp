#include "solver/active_part.hpp"
#include "base/dense_kernels.hpp"
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

constexpr Eigen::Index INVERSE_FROM =
    8; // columns to be solved for, an eighth of the rows: the inverse costs no more

} // namespace

void ActivePart::set(std::shared_ptr<const Eigen::MatrixXd> matrix, bool symmetric, Parts parts) {
  m_matrix = std::move(matrix);
  m_symmetric = symmetric;
  m_parts = std::move(parts);
  m_order.clear();
  m_selected.clear();
  m_place.clear();
  m_stands.clear();
  m_inverse.resize(0, 0);
}

bool ActivePart::factorize() {
  const auto n = static_cast<Eigen::Index>(m_order.size());
  ++m_factorizations;
  if (!m_symmetric) {
    m_lu.compute((*m_matrix)(m_order, m_order));
    return n == 0 || m_lu.matrixLU().diagonal().cwiseAbs().minCoeff() > 0; // NaN is no factor either
  }
  m_lower.resize(n, n);
  for (Eigen::Index j = 0; j < n; ++j)
    for (Eigen::Index i = j; i < n; ++i) m_lower(i, j) = (*m_matrix)(m_order[i], m_order[j]);
  return cholesky(m_lower);
}

// A row at the end: L y = c, diagonal sqrt(C_jj - y.y).
bool ActivePart::append(int place) {
  const auto n = static_cast<Eigen::Index>(m_order.size());
  Eigen::VectorXd y(n);
  for (Eigen::Index i = 0; i < n; ++i) y[i] = (*m_matrix)(m_order[i], place);
  m_lower.topLeftCorner(n, n).triangularView<Eigen::Lower>().solveInPlace(y);
  const double rest = (*m_matrix)(place, place) - y.squaredNorm();
  if (!(rest > 0)) return false;
  if (m_lower.rows() == n) m_lower.conservativeResize(n + n / 4 + 8, n + n / 4 + 8);
  m_lower.row(n).head(n) = y.transpose();
  m_lower(n, n) = std::sqrt(rest);
  m_order.push_back(place);
  ++m_updates;
  return true;
}

// The row goes; what its column carried is rotated into the rest: L33 L33' + l l'.
void ActivePart::remove(Eigen::Index position) {
  const auto n = static_cast<Eigen::Index>(m_order.size());
  Eigen::VectorXd l = m_lower.col(position).segment(position + 1, n - position - 1);
  for (Eigen::Index j = position + 1; j < n; ++j) { // columns move up and to the left
    m_lower.row(j - 1).head(position) = m_lower.row(j).head(position);
    m_lower.col(j - 1).segment(j - 1, n - j) = m_lower.col(j).segment(j, n - j).eval();
  }
  for (Eigen::Index k = 0; k < l.size(); ++k) {
    const Eigen::Index j = position + k, below = l.size() - k - 1;
    const double r = std::hypot(m_lower(j, j), l[k]), c = m_lower(j, j) / r, s = l[k] / r;
    m_lower(j, j) = r;
    const Eigen::VectorXd column = m_lower.col(j).segment(j + 1, below);
    m_lower.col(j).segment(j + 1, below) = c * column + s * l.tail(below);
    l.tail(below) = (c * l.tail(below) - s * column).eval();
  }
  m_order.erase(m_order.begin() + position);
  ++m_updates;
}

bool ActivePart::update(const std::vector<int>& places) {
  if (!m_symmetric) return false;
  std::vector<char> wanted(m_matrix->rows(), 0), kept(m_matrix->rows(), 0);
  for (const int i : places) wanted[i] = 1;
  for (const int i : m_order) kept[i] = wanted[i];
  const auto gone = std::count_if(m_order.begin(), m_order.end(), [&](int i) { return !wanted[i]; });
  const auto fresh = std::count_if(places.begin(), places.end(), [&](int i) { return !kept[i]; });
  const auto size = static_cast<std::ptrdiff_t>(places.size());
  if (static_cast<int>(m_order.size()) < m_updates_from || 6 * (gone + fresh) > size) return false;
  for (auto k = static_cast<Eigen::Index>(m_order.size()) - 1; k >= 0; --k)
    if (!wanted[m_order[k]]) remove(k);
  for (const int i : places)
    if (!kept[i] && !append(i)) return false;
  return true;
}

bool ActivePart::select(const std::vector<int>& indices) {
  if (indices == m_selected && !m_order.empty()) return true;
  m_selected = indices;
  m_inverse.resize(0, 0);
  const std::vector<int> places = m_parts.places ? m_parts.places(indices) : indices;
  if (!update(places)) {
    m_order = places;
    if (!factorize()) {
      m_order.clear();
      m_selected.clear();
      return false;
    }
  }
  std::vector<Eigen::Index> row(m_matrix->rows(), -1);
  for (std::size_t k = 0; k < m_order.size(); ++k) row[m_order[k]] = static_cast<Eigen::Index>(k);
  m_place.clear();
  for (const int i : places) m_place.push_back(row[i]);
  m_stands.assign(indices.empty() ? 0 : 1 + *std::max_element(indices.begin(), indices.end()), -1);
  for (std::size_t k = 0; k < indices.size(); ++k) m_stands[indices[k]] = places[k];
  return true;
}

void ActivePart::add_product(const Eigen::VectorXd& x, Eigen::VectorXd& y) const {
  if (m_parts.times) {
    y += m_parts.times(x);
    return;
  }
  for (Eigen::Index k = 0; k < x.size(); ++k)
    if (x[k] != 0) y += x[k] * m_matrix->col(k);
}

double ActivePart::entry(int i, int j) const {
  const int last = static_cast<int>(m_stands.size()) - 1;
  if (std::max(i, j) > last || m_stands[i] < 0 || m_stands[j] < 0) return 0;
  return (*m_matrix)(m_stands[i], m_stands[j]);
}

Eigen::MatrixXd ActivePart::solve(const Eigen::MatrixXd& B) const {
  if (!m_symmetric) return m_order.empty() ? Eigen::MatrixXd(0, B.cols()) : Eigen::MatrixXd(m_lu.solve(B));
  const auto n = static_cast<Eigen::Index>(m_order.size());
  Eigen::MatrixXd X(n, B.cols());
  for (Eigen::Index j = 0; j < B.cols(); ++j)
    for (Eigen::Index i = 0; i < n; ++i) X(m_place[i], j) = B(i, j);
  if (m_inverse.rows() > 0 || (n >= LARGE_BLOCK && INVERSE_FROM * B.cols() > n)) {
    if (m_inverse.rows() == 0) m_inverse = inverse_from_cholesky(m_lower, n);
    X = (m_inverse * X.sparseView()).eval();
  } else {
    const MatrixPart L{m_lower.data(), static_cast<int>(n), static_cast<int>(n),
                       static_cast<int>(m_lower.rows())};
    solve_lower(L, false, X);
    solve_lower(L, true, X);
  }
  Eigen::MatrixXd result(n, B.cols());
  for (Eigen::Index j = 0; j < B.cols(); ++j)
    for (Eigen::Index i = 0; i < n; ++i) result(i, j) = X(m_place[i], j);
  return result;
}

} // namespace burnish
