#include "solver/node_block_matrix.hpp"
#include "base/error.hpp"
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace burnish {

namespace {

constexpr std::size_t NO_SLOT = std::numeric_limits<std::size_t>::max();

/// Sorts every row, drops repeated columns and packs the rows.
template <int Dim> NodeBlockMatrix<Dim> pack(std::vector<std::vector<int>>& rows) {
  NodeBlockMatrix<Dim> matrix;
  matrix.num_nodes = static_cast<int>(rows.size());
  matrix.row_start.assign(1, 0);
  matrix.row_start.reserve(rows.size() + 1);
  for (std::vector<int>& row : rows) {
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    matrix.col.insert(matrix.col.end(), row.begin(), row.end());
    matrix.row_start.push_back(static_cast<int>(matrix.col.size()));
  }
  matrix.value.assign(matrix.col.size() * Dim * Dim, 0.);
  return matrix;
}

/// One empty list per node that holds the diagonal block only.
std::vector<std::vector<int>> diagonal_rows(int num_nodes) {
  std::vector<std::vector<int>> rows(num_nodes);
  for (int node = 0; node < num_nodes; ++node) rows[node].push_back(node);
  return rows;
}

template <int Dim> void check_triplets(const TripletView& triplets) {
  const char* where = "TripletReader::read";
  require(triplets.n > 0 && triplets.n % Dim == 0, where, "n", triplets.n,
          ("a positive multiple of " + std::to_string(Dim)).c_str());
  if (triplets.nnz > 0 && !(triplets.row && triplets.col && triplets.value))
    fail(where, "row, col or value is a null pointer");
}

/// Indices in range; a half matrix must not have entries on both sides of the diagonal.
void check_indices(const TripletView& triplets) {
  const char* where = "TripletReader::read";
  bool lower = false, upper = false;
  for (std::size_t k = 0; k < triplets.nnz; ++k) {
    const int row = triplets.row[k], col = triplets.col[k];
    require(row >= 0 && row < triplets.n, where, "row", row, "0 <= row < n");
    require(col >= 0 && col < triplets.n, where, "col", col, "0 <= col < n");
    lower = lower || row > col;
    upper = upper || row < col;
    if (triplets.half && lower && upper) {
      std::ostringstream what;
      what << "entry (" << row << ", " << col << ") is in the other triangle than the entries before it, "
           << "expected one triangle of a half matrix";
      fail(where, what.str());
    }
  }
}

void check_finite(const TripletView& triplets) {
  // a sum of zeros unless something is not finite; the place is looked for only then
  double sum = 0;
  for (std::size_t k = 0; k < triplets.nnz; ++k) sum += 0. * triplets.value[k];
  if (sum == 0.) return;
  for (std::size_t k = 0; k < triplets.nnz; ++k) {
    if (std::isfinite(triplets.value[k])) continue;
    std::ostringstream what;
    what << "value of entry (row " << triplets.row[k] << ", column " << triplets.col[k]
         << ") = " << triplets.value[k] << ", expected a finite number";
    fail("TripletReader::read", what.str());
  }
}

/// Block pattern of the triplets with its transpose and the diagonal.
template <int Dim> NodeBlockMatrix<Dim> pattern_from_triplets(const TripletView& triplets) {
  std::vector<std::vector<int>> rows = diagonal_rows(triplets.n / Dim);
  for (std::size_t k = 0; k < triplets.nnz; ++k) {
    const int row = triplets.row[k] / Dim, col = triplets.col[k] / Dim;
    if (row == col) continue;
    if (rows[row].back() != col) rows[row].push_back(col);
    if (rows[col].back() != row) rows[col].push_back(row);
  }
  return pack<Dim>(rows);
}

/// Position in NodeBlockMatrix::value of the entry (row, col); its block must exist.
template <int Dim> std::size_t slot_of(const NodeBlockMatrix<Dim>& matrix, int row, int col) {
  const std::size_t block = matrix.find(row / Dim, col / Dim);
  return block * Dim * Dim + static_cast<std::size_t>(row % Dim) * Dim + col % Dim;
}

} // namespace

template <int Dim> int NodeBlockMatrix<Dim>::find(int row, int col_node) const {
  if (row < 0 || row >= num_nodes) return -1;
  const auto first = col.begin() + row_start[row], last = col.begin() + row_start[row + 1];
  const auto place = std::lower_bound(first, last, col_node);
  return place != last && *place == col_node ? static_cast<int>(place - col.begin()) : -1;
}

template <int Dim> Eigen::VectorXd NodeBlockMatrix<Dim>::multiply(const Eigen::VectorXd& x) const {
  require(x.size() == size(), "NodeBlockMatrix::multiply", "x.size()", x.size(), "Dim*num_nodes");
  Eigen::VectorXd y(size());
  for (int row = 0; row < num_nodes; ++row) {
    Vector<Dim> sum = Vector<Dim>::Zero();
    for (int k = row_start[row]; k < row_start[row + 1]; ++k)
      sum += Eigen::Map<const Eigen::Matrix<double, Dim, Dim, Eigen::RowMajor>>(block(k)) *
             x.template segment<Dim>(static_cast<Eigen::Index>(Dim) * col[k]);
    y.template segment<Dim>(static_cast<Eigen::Index>(Dim) * row) = sum;
  }
  return y;
}

template <int Dim>
NodeBlockMatrix<Dim> pattern_from_elements(int num_nodes, int nodes_per_element,
                                           const std::vector<int>& connectivity) {
  const char* where = "pattern_from_elements";
  require(num_nodes > 0, where, "num_nodes", num_nodes, "num_nodes > 0");
  require(nodes_per_element > 0, where, "nodes_per_element", nodes_per_element, "nodes_per_element > 0");
  require(connectivity.size() % nodes_per_element == 0, where, "connectivity.size()", connectivity.size(),
          "a multiple of nodes_per_element");
  for (int node : connectivity)
    require(node >= 0 && node < num_nodes, where, "node", node, "0 <= node < num_nodes");
  // elements of every node first, so that a row is collected without repetitions
  std::vector<std::vector<std::size_t>> elements(num_nodes);
  for (std::size_t k = 0; k < connectivity.size(); ++k)
    elements[connectivity[k]].push_back(k / nodes_per_element * nodes_per_element);
  std::vector<int> last_row(num_nodes, -1);
  std::vector<std::vector<int>> rows = diagonal_rows(num_nodes);
  for (int row = 0; row < num_nodes; ++row) {
    last_row[row] = row;
    for (std::size_t first : elements[row]) {
      for (int i = 0; i < nodes_per_element; ++i) {
        const int node = connectivity[first + i];
        if (last_row[node] != row) rows[row].push_back(node);
        last_row[node] = row;
      }
    }
  }
  return pack<Dim>(rows);
}

template <int Dim> const NodeBlockMatrix<Dim>& TripletReader<Dim>::read(const TripletView& triplets) {
  check_triplets<Dim>(triplets);
  const bool known = triplets.n == m_matrix.size() && triplets.half == m_half &&
                     triplets.nnz == m_row.size() && std::equal(m_row.begin(), m_row.end(), triplets.row) &&
                     std::equal(m_col.begin(), m_col.end(), triplets.col);
  if (!known) check_indices(triplets);
  check_finite(triplets);
  if (!known) build(triplets);
  std::fill(m_matrix.value.begin(), m_matrix.value.end(), 0.);
  for (std::size_t k = 0; k < triplets.nnz; ++k) m_matrix.value[m_slot[k]] += triplets.value[k];
  if (m_half) {
    for (std::size_t k = 0; k < triplets.nnz; ++k)
      if (m_slot_mirror[k] != NO_SLOT) m_matrix.value[m_slot_mirror[k]] += triplets.value[k];
  }
  return m_matrix;
}

template <int Dim> void TripletReader<Dim>::build(const TripletView& triplets) {
  TripletReader fresh;
  fresh.m_matrix = pattern_from_triplets<Dim>(triplets);
  fresh.m_row.assign(triplets.row, triplets.row + triplets.nnz);
  fresh.m_col.assign(triplets.col, triplets.col + triplets.nnz);
  fresh.m_half = triplets.half;
  fresh.m_builds = m_builds + 1;
  fresh.m_slot.resize(triplets.nnz);
  if (triplets.half) fresh.m_slot_mirror.assign(triplets.nnz, NO_SLOT);
  for (std::size_t k = 0; k < triplets.nnz; ++k) {
    const int row = triplets.row[k], col = triplets.col[k];
    fresh.m_slot[k] = slot_of(fresh.m_matrix, row, col);
    if (triplets.half && row != col) fresh.m_slot_mirror[k] = slot_of(fresh.m_matrix, col, row);
  }
  *this = std::move(fresh);
}

template struct NodeBlockMatrix<2>;
template struct NodeBlockMatrix<3>;
template class TripletReader<2>;
template class TripletReader<3>;
template NodeBlockMatrix<2> pattern_from_elements<2>(int, int, const std::vector<int>&);
template NodeBlockMatrix<3> pattern_from_elements<3>(int, int, const std::vector<int>&);

} // namespace burnish
