#pragma once
// The free part of a node-block matrix in the order of elimination: interior by a fill-reducing order, then
// the contact candidates, whose Schur complement is thereby the trailing block of the factor
// (METHOD.md 5.3).
#include "solver/node_block_matrix.hpp"
#include <array>
#include <cstdint>
#include <vector>

namespace burnish {

/// Lower triangle by columns of P A P', A without its fixed dofs. Rows within a column are in no order.
struct PermutedTriangle {
  std::vector<int> order;          ///< free dofs in the order of elimination
  int num_interior = 0;            ///< the first of them, the others belong to candidates
  std::array<int, 2> halves{0, 0}; ///< the first of these, of a body that two ranks divide: of either half
  std::vector<int> col_start{0};   ///< order.size() + 1
  std::vector<int> row;            ///< per entry, >= its column
  std::vector<std::uint32_t> slot; ///< per entry, its place in NodeBlockMatrix::value (lower triangle of A)
  std::vector<int> diagonal;       ///< entry on the diagonal of every column of a candidate
};

/// What permute_candidates_last refuses, without doing it.
/// @throws std::invalid_argument as permute_candidates_last
template <int Dim>
void require_permutable(const NodeBlockMatrix<Dim>& pattern, const std::vector<char>& fixed,
                        const std::vector<int>& candidates);

/// @param fixed       Dim*num_nodes flags, nonzero: left out
/// @param candidates  nodes that come last, in this order, each with its free dofs in ascending order
/// @throws std::invalid_argument on a pattern that is not sorted, not structurally symmetric or without a
/// diagonal block, of 2^32 values or more, a wrong number of flags, a candidate out of range or named twice
template <int Dim>
PermutedTriangle permute_candidates_last(const NodeBlockMatrix<Dim>& pattern, const std::vector<char>& fixed,
                                         const std::vector<int>& candidates);

} // namespace burnish
