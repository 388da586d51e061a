#include "solver/sparse_rows.hpp"
#include <algorithm>

namespace burnish {

SparseRows rows_of(const TripletView& entries) {
  SparseRows rows{entries.n, entries.half, std::vector<int>(entries.n + 1, 0), {}, {}};
  for (std::size_t k = 0; k < entries.nnz; ++k) ++rows.row_start[entries.row[k] + 1];
  for (int r = 0; r < entries.n; ++r) rows.row_start[r + 1] += rows.row_start[r];
  std::vector<int> next(rows.row_start.begin(), rows.row_start.end() - 1);
  std::vector<std::size_t> order(entries.nnz);
  for (std::size_t k = 0; k < entries.nnz; ++k) order[next[entries.row[k]]++] = k;
  for (int r = 0; r < entries.n; ++r)
    std::sort(order.begin() + rows.row_start[r], order.begin() + rows.row_start[r + 1],
              [&](std::size_t a, std::size_t b) { return entries.col[a] < entries.col[b]; });
  for (const std::size_t k : order) {
    rows.col.push_back(entries.col[k]);
    rows.value.push_back(entries.value[k]);
  }
  return rows;
}

namespace {

template <int Dim> SparseRows rows_of_blocks(const NodeBlockMatrix<Dim>& K, bool lower) {
  SparseRows rows{K.size(), lower, {0}, {}, {}};
  for (int row = 0; row < K.size(); ++row) {
    for (int k = K.row_start[row / Dim]; k < K.row_start[row / Dim + 1]; ++k)
      for (int c = 0; c < Dim && (!lower || Dim * K.col[k] + c <= row); ++c) {
        rows.col.push_back(Dim * K.col[k] + c);
        rows.value.push_back(K.block(k)[Dim * (row % Dim) + c]);
      }
    rows.row_start.push_back(static_cast<int>(rows.col.size()));
  }
  return rows;
}

} // namespace

template <int Dim> SparseRows lower_triangle(const NodeBlockMatrix<Dim>& K) {
  return rows_of_blocks(K, true);
}
template <int Dim> SparseRows all_rows(const NodeBlockMatrix<Dim>& K) { return rows_of_blocks(K, false); }

template SparseRows lower_triangle<2>(const NodeBlockMatrix<2>&);
template SparseRows lower_triangle<3>(const NodeBlockMatrix<3>&);
template SparseRows all_rows<2>(const NodeBlockMatrix<2>&);
template SparseRows all_rows<3>(const NodeBlockMatrix<3>&);

std::vector<int> places_by_columns(const SparseView& rows) {
  const int nnz = rows.row_start[rows.n];
  std::vector<int> next(static_cast<std::size_t>(rows.n) + 1, 0), place(nnz);
  for (int k = 0; k < nnz; ++k) ++next[rows.col[k] + 1];
  for (int c = 0; c < rows.n; ++c) next[c + 1] += next[c];
  for (int k = 0; k < nnz; ++k) place[k] = next[rows.col[k]]++; // rows ascend
  return place;
}

} // namespace burnish
