#pragma once
// A square sparse matrix by rows as somebody else keeps it: what the general solvers take.
#include <vector>

namespace burnish {

/// Row i holds entries row_start[i] .. row_start[i+1] with columns strictly ascending, 0-based. `symmetric`:
/// only one triangle (either one, with the diagonal) is stored and stands for both.
struct SparseView {
  int n = 0;
  const int* row_start = nullptr; ///< n + 1
  const int* col = nullptr;
  const double* value = nullptr;
  bool symmetric = false;
};

/// Copy of a pattern, to know it again and to address its entries.
struct SparsePattern {
  int n = 0;
  bool symmetric = false;
  std::vector<int> row_start, col;
  /// Entry (j, i) for the entry (i, j) at every place, -1 where it is not stored.
  std::vector<int> mirror;

  /// @param where  the caller's name for the message
  /// @throws std::invalid_argument if n < 1, an array is missing, columns are out of range or not ascending,
  /// or a symmetric view has entries in both triangles
  SparsePattern(const char* where, const SparseView& view);
  SparsePattern() = default;
  bool matches(const SparseView& view) const;
};

/// @throws std::invalid_argument naming row, column and value if a value is not finite
void check_values(const char* where, const SparseView& view);

} // namespace burnish
