#include "solver/asymmetry.hpp"
#include <algorithm>
#include <cmath>
#include <queue>

namespace burnish {

std::vector<std::pair<int, int>> asymmetric_pairs(const SparsePattern& pattern, const SparseView& view,
                                                  double tolerance) {
  std::vector<std::pair<int, int>> pairs;
  if (view.symmetric) return pairs;
  std::vector<double> scale(pattern.n, 0.);
  for (int row = 0; row < pattern.n; ++row)
    for (int k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k)
      scale[row] = std::max(scale[row], std::abs(view.value[k]));
  for (int row = 0; row < pattern.n; ++row) {
    for (int k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k) {
      const int col = pattern.col[k], mirror = pattern.mirror[k];
      // a pair stored on both sides is looked at once
      if (col == row || (mirror >= 0 && col > row)) continue;
      const double difference = view.value[k] - (mirror >= 0 ? view.value[mirror] : 0.);
      if (std::abs(difference) > tolerance * std::min(scale[row], scale[col]))
        pairs.emplace_back(std::max(row, col), std::min(row, col));
    }
  }
  return pairs;
}

double largest_asymmetry(const SparseView& view) {
  if (view.symmetric) return 0;
  const auto entry = [&](int row, int col) {
    const int *begin = view.col + view.row_start[row], *end = view.col + view.row_start[row + 1];
    const int* at = std::lower_bound(begin, end, col);
    return at != end && *at == col ? view.value[at - view.col] : 0.;
  };
  double largest = 0, difference = 0;
  for (int row = 0; row < view.n; ++row)
    for (int k = view.row_start[row]; k < view.row_start[row + 1]; ++k) {
      largest = std::max(largest, std::abs(view.value[k]));
      difference = std::max(difference, std::abs(view.value[k] - entry(view.col[k], row)));
    }
  return largest > 0 ? difference / largest : 0;
}

std::vector<int> greedy_cover(int n, const std::vector<std::pair<int, int>>& pairs, int max_size) {
  std::vector<std::vector<int>> partners(n);
  for (auto [i, j] : pairs) {
    partners[i].push_back(j);
    partners[j].push_back(i);
  }
  std::vector<int> degree(n), cover;
  std::vector<char> is_taken(n, 0);
  std::priority_queue<std::pair<int, int>> queue; // (degree, -index), with outdated elements
  for (int i = 0; i < n; ++i) {
    degree[i] = static_cast<int>(partners[i].size());
    if (degree[i] > 0) queue.emplace(degree[i], -i);
  }
  while (!queue.empty() && static_cast<int>(cover.size()) <= max_size) {
    const auto [count, negative] = queue.top();
    const int index = -negative;
    queue.pop();
    if (is_taken[index] || count != degree[index]) continue;
    is_taken[index] = 1;
    cover.push_back(index);
    for (int partner : partners[index])
      if (!is_taken[partner] && --degree[partner] > 0) queue.emplace(degree[partner], -partner);
  }
  std::sort(cover.begin(), cover.end());
  return cover;
}

} // namespace burnish
