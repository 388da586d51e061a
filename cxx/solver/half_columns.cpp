#include "solver/half_columns.hpp"
#include "base/dense_kernels.hpp"
#include <algorithm>
#include <numeric>
#include <utility>

namespace burnish {
namespace {

constexpr std::ptrdiff_t TOGETHER = 64; // columns under way

} // namespace

HalfColumns::HalfColumns(const Supernodes& L, const std::vector<int>& place)
    : m_L(L), m_place(place), m_supernode(L.size), m_panels(L.count), m_passing(L.count) {
  for (int s = 0; s < L.count; ++s)
    std::fill(m_supernode.begin() + L.first[s], m_supernode.begin() + L.first[s + 1], s);
}

// Neighbors in the order of elimination share most of their way.
void HalfColumns::append(const std::vector<int>& rows, Eigen::MatrixXd& gram) {
  if (m_rest.size() == 0) m_rest.setZero(m_L.size, TOGETHER);
  std::vector<int> order(rows.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return m_place[rows[a]] < m_place[rows[b]]; });
  const int* const end = order.data() + order.size();
  for (const int* first = order.data(); first < end;) {
    const int* const last = first + std::min(TOGETHER, end - first);
    append_some(first, last, rows, gram);
    first = last;
  }
  m_known += static_cast<int>(rows.size());
}

void HalfColumns::append_some(const int* first, const int* last, const std::vector<int>& rows,
                              Eigen::MatrixXd& gram) {
  std::vector<int> way;
  m_numbers.clear();
  for (const int* k = first; k < last; ++k) {
    const int row = m_place[rows[*k]], at = static_cast<int>(m_numbers.size());
    m_numbers.push_back(m_known + *k);
    m_rest(row, at) = 1;
    for (int s = m_supernode[row];;) {
      if (m_passing[s].empty()) way.push_back(s);
      m_passing[s].push_back(at);
      const int own = m_L.num_columns(s);
      if (own == m_L.num_rows(s)) break;
      s = m_supernode[m_L.rows[m_L.row_begin[s] + own]];
    }
  }
  std::sort(way.begin(), way.end());
  for (const int s : way) pass(s, gram);
  for (const int j : m_numbers) gram.row(j) = gram.col(j).transpose();
}

// One supernode of the forward substitution, and what it adds to the products.
void HalfColumns::pass(int s, Eigen::MatrixXd& gram) {
  std::vector<int>& passing = m_passing[s];
  const int own = m_L.num_columns(s), below = m_L.num_rows(s) - own, stride = m_L.num_rows(s);
  const auto columns = static_cast<Eigen::Index>(passing.size());
  Eigen::MatrixXd X(own, columns);
  for (Eigen::Index i = 0; i < own; ++i)
    for (Eigen::Index k = 0; k < columns; ++k)
      X(i, k) = std::exchange(m_rest(m_L.first[s] + i, passing[k]), 0.);
  solve_lower({m_L.panel(s), own, own, stride}, false, X);
  if (below > 0) {
    Eigen::MatrixXd carried(below, columns);
    multiply({m_L.panel(s) + own, below, own, stride}, false, X, carried);
    const int* const rows = m_L.rows + m_L.row_begin[s] + own;
    for (Eigen::Index i = 0; i < below; ++i)
      for (Eigen::Index k = 0; k < columns; ++k) m_rest(rows[i], passing[k]) -= carried(i, k);
  }
  Panel& panel = m_panels[s];
  panel.values.insert(panel.values.end(), X.data(), X.data() + X.size());
  for (const int at : passing) panel.columns.push_back(m_numbers[at]);
  Eigen::MatrixXd products(static_cast<Eigen::Index>(panel.columns.size()), columns);
  multiply({panel.values.data(), own, static_cast<int>(products.rows()), own}, true, X, products);
  for (Eigen::Index k = 0; k < columns; ++k) {
    double* const column = &gram(0, m_numbers[passing[k]]);
    for (Eigen::Index i = 0; i < products.rows(); ++i) column[panel.columns[i]] += products(i, k);
  }
  passing.clear();
}

Eigen::VectorXd HalfColumns::sum(const Eigen::VectorXd& weight) const {
  Eigen::VectorXd y = Eigen::VectorXd::Zero(m_L.size);
  for (int s = 0; s < m_L.count; ++s) {
    const Panel& panel = m_panels[s];
    const auto own = static_cast<Eigen::Index>(m_L.num_columns(s)),
               columns = static_cast<Eigen::Index>(panel.columns.size());
    if (columns > 0)
      y.segment(m_L.first[s], own) =
          Eigen::Map<const Eigen::MatrixXd>(panel.values.data(), own, columns) * weight(panel.columns);
  }
  return y;
}

} // namespace burnish
