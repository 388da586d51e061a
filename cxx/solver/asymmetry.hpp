#pragma once
// Where a matrix is not symmetric, and few rows that contain all such places.
#include "solver/sparse_view.hpp"
#include <utility>
#include <vector>

namespace burnish {

/// Pairs (i > j) with |a_ij - a_ji| > tolerance * min(m_i, m_j), m_i the largest magnitude in row i; an entry
/// that is not stored is zero. Empty for a view with `symmetric`.
/// @param pattern  of the same view
std::vector<std::pair<int, int>> asymmetric_pairs(const SparsePattern& pattern, const SparseView& view,
                                                  double tolerance);

/// Largest |a_ij - a_ji| over the largest |a_ij|; 0 for a view with `symmetric` and for a matrix of zeros.
double largest_asymmetry(const SparseView& view);

/// Greedy vertex cover: takes the index that is in most of the pairs left (the smallest of equals) until none
/// is left or more than max_size are taken.
/// @return ascending; longer than max_size if no cover of that size was found
std::vector<int> greedy_cover(int n, const std::vector<std::pair<int, int>>& pairs, int max_size);

} // namespace burnish
