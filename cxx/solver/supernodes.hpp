#pragma once
// A supernodal factor, to be read.

namespace burnish {

/// L of L L' by dense panels: supernode s has the columns first[s] .. first[s+1] and the rows rows[row_begin[s] .. row_begin[s+1]),
/// ascending, its own columns first. Its values stand column by column from value_begin[s] on, as many rows a column; what
/// stands above the diagonal is not to be read. Valid until the next factor.
struct Supernodes {
  int size = 0;  ///< rows of L
  int count = 0; ///< of supernodes
  const int* first = nullptr;
  const int* row_begin = nullptr;
  const int* value_begin = nullptr;
  const int* rows = nullptr;
  const double* values = nullptr;

  int num_columns(int s) const { return first[s + 1] - first[s]; }
  int num_rows(int s) const { return row_begin[s + 1] - row_begin[s]; }
  const double* panel(int s) const { return values + value_begin[s]; }
};

} // namespace burnish
