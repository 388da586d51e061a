#include "solver/sparse_view.hpp"
#include "base/error.hpp"
#include <algorithm>
#include <cmath>
#include <string>

namespace burnish {

namespace {

void check_row(const char* where, const SparseView& view, int row) {
  require(view.row_start[row] <= view.row_start[row + 1], where, "row_start[row + 1]",
          view.row_start[row + 1], "not less than row_start[row]");
  for (int k = view.row_start[row]; k < view.row_start[row + 1]; ++k) {
    require(view.col[k] >= 0 && view.col[k] < view.n, where, "col", view.col[k], "0 <= col < n");
    if (k > view.row_start[row] && view.col[k] <= view.col[k - 1])
      fail(where, "columns of row " + std::to_string(row) + " are not strictly ascending");
  }
}

void check_pattern(const char* where, const SparseView& view) {
  require(view.n >= 1, where, "n", view.n, "n >= 1");
  if (!view.row_start) fail(where, "row_start is a null pointer");
  require(view.row_start[0] == 0, where, "row_start[0]", view.row_start[0], "0");
  if (!view.col && view.row_start[view.n] != 0) fail(where, "col is a null pointer");
  bool lower = false, upper = false;
  for (int row = 0; row < view.n; ++row) {
    check_row(where, view, row);
    if (view.row_start[row] == view.row_start[row + 1]) continue;
    lower = lower || view.col[view.row_start[row]] < row;
    upper = upper || view.col[view.row_start[row + 1] - 1] > row;
  }
  if (view.symmetric && lower && upper) fail(where, "a symmetric matrix has entries in both triangles");
}

} // namespace

SparsePattern::SparsePattern(const char* where, const SparseView& view)
    : n(view.n), symmetric(view.symmetric) {
  check_pattern(where, view);
  row_start.assign(view.row_start, view.row_start + n + 1);
  col.assign(view.col, view.col + row_start.back());
  mirror.assign(col.size(), -1);
  for (int row = 0; row < n; ++row) {
    for (int k = row_start[row]; k < row_start[row + 1]; ++k) {
      const auto first = col.begin() + row_start[col[k]], last = col.begin() + row_start[col[k] + 1];
      const auto place = std::lower_bound(first, last, row);
      if (place != last && *place == row) mirror[k] = static_cast<int>(place - col.begin());
    }
  }
}

bool SparsePattern::matches(const SparseView& view) const {
  return n > 0 && view.n == n && view.symmetric == symmetric && view.row_start && view.col &&
         std::equal(row_start.begin(), row_start.end(), view.row_start) &&
         std::equal(col.begin(), col.end(), view.col);
}

void check_values(const char* where, const SparseView& view) {
  const int nnz = view.row_start[view.n];
  if (nnz > 0 && !view.value) fail(where, "value is a null pointer");
  double sum = 0; // stays zero unless a value is not finite
  for (int k = 0; k < nnz; ++k) sum += 0. * view.value[k];
  if (sum == 0.) return;
  for (int row = 0; row < view.n; ++row) {
    for (int k = view.row_start[row]; k < view.row_start[row + 1]; ++k) {
      if (std::isfinite(view.value[k])) continue;
      std::ostringstream what;
      what << "value of entry (row " << row << ", column " << view.col[k] << ") = " << view.value[k]
           << ", expected a finite number";
      fail(where, what.str());
    }
  }
}

} // namespace burnish
