#include "solver/free_rows.hpp"
#include "base/error.hpp"
#include <Eigen/SparseCore>
#include <cmath>

namespace burnish {

template <int Dim>
FreeRows<Dim>::FreeRows(const NodeBlockMatrix<Dim>& pattern, const std::vector<char>& fixed, bool half)
    : m_place(fixed.size(), -1) {
  for (std::size_t d = 0; d < fixed.size(); ++d)
    if (!fixed[d]) {
      m_place[d] = static_cast<int>(m_free.size());
      m_free.push_back(static_cast<int>(d));
    }
  m_rows.n = static_cast<int>(m_free.size());
  m_rows.symmetric = half;
  m_rows.row_start = {0};
  for (const int row : m_free) {
    for (int k = pattern.row_start[row / Dim]; k < pattern.row_start[row / Dim + 1]; ++k)
      for (int c = 0; c < Dim; ++c) {
        const int d = Dim * pattern.col[k] + c;
        if (m_place[d] < 0 || (half && d > row)) continue;
        if (d == row) m_diagonal.push_back(static_cast<int>(m_rows.col.size()));
        m_rows.col.push_back(m_place[d]);
        m_slot.push_back(static_cast<std::uint32_t>(Dim * Dim * k + Dim * (row % Dim) + c));
      }
    m_rows.row_start.push_back(static_cast<int>(m_rows.col.size()));
  }
  m_rows.value.assign(m_slot.size(), 0);
}

template <int Dim> void FreeRows<Dim>::take_values(const NodeBlockMatrix<Dim>& K) {
  for (std::size_t k = 0; k < m_slot.size(); ++k) m_rows.value[k] = K.value[m_slot[k]];
}

template <int Dim> Eigen::VectorXd FreeRows<Dim>::product(const Eigen::VectorXd& x) const {
  const Eigen::Map<const Eigen::SparseMatrix<double, Eigen::RowMajor>> K(
      m_rows.n, m_rows.n, static_cast<Eigen::Index>(m_rows.value.size()), m_rows.row_start.data(),
      m_rows.col.data(), m_rows.value.data());
  if (m_rows.symmetric) return K.template selfadjointView<Eigen::Lower>() * x;
  return K * x;
}

template <int Dim>
Eigen::VectorXd FreeRows<Dim>::gathered(const Eigen::VectorXd& b, const char* where) const {
  require(static_cast<std::size_t>(b.size()) == m_place.size(), where, "b.size()", b.size(), "Dim*num_nodes");
  for (const int d : m_free)
    if (!std::isfinite(b[d]))
      fail(where, "b[" + std::to_string(d) + "] is not finite, expected finite numbers");
  return b(m_free);
}

template <int Dim> Eigen::VectorXd FreeRows<Dim>::scattered(const Eigen::VectorXd& x) const {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(m_place.size()));
  all(m_free) = x;
  return all;
}

template class FreeRows<2>;
template class FreeRows<3>;

} // namespace burnish
