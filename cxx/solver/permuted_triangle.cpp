#include "solver/permuted_triangle.hpp"
#include "base/error.hpp"
#include "solver/ordered_factor.hpp"
#include "solver/required_memory.hpp"
#include <algorithm>
#include <limits>
#include <utility>

namespace burnish {

namespace {

/// Index of block (j, i) for the block (i, j) at every place of a structurally symmetric pattern.
template <int Dim> std::vector<int> transposed_blocks(const NodeBlockMatrix<Dim>& pattern) {
  std::vector<int> transposed(pattern.col.size());
  std::vector<int> next(pattern.row_start.begin(), pattern.row_start.end());
  for (int row = 0; row < pattern.num_nodes; ++row) {
    for (int k = pattern.row_start[row]; k < pattern.row_start[row + 1]; ++k) {
      // rows come in ascending order, so the entries of row col[k] are met in their order
      const int mirror = next[pattern.col[k]]++;
      if (mirror >= pattern.row_start[pattern.col[k] + 1] || pattern.col[mirror] != row)
        fail("SchurFactor::analyze", "the pattern is not structurally symmetric with ascending columns");
      transposed[k] = mirror;
    }
    if (pattern.find(row, row) < 0)
      fail("SchurFactor::analyze", "no diagonal block of node " + std::to_string(row));
  }
  return transposed;
}

template <int Dim> void check_pattern(const NodeBlockMatrix<Dim>& pattern) {
  const char* where = "SchurFactor::analyze";
  require(pattern.num_nodes > 0, where, "num_nodes", pattern.num_nodes, "num_nodes > 0");
  const std::size_t num_rows = pattern.num_nodes;
  require(pattern.row_start.size() == num_rows + 1, where, "row_start.size()", pattern.row_start.size(),
          "num_nodes + 1");
  for (std::size_t row = 0; row < num_rows; ++row)
    require(pattern.row_start[row] <= pattern.row_start[row + 1], where, "row_start[row + 1]",
            pattern.row_start[row + 1], "not less than row_start[row]");
  require(pattern.row_start.front() == 0 &&
              static_cast<std::size_t>(pattern.row_start.back()) == pattern.col.size(),
          where, "row_start.back()", pattern.row_start.back(), "col.size(), row_start from 0");
  for (int node : pattern.col)
    require(node >= 0 && node < pattern.num_nodes, where, "col", node, "0 <= col < num_nodes");
}

template <int Dim> void check_size(const NodeBlockMatrix<Dim>& pattern) {
  const std::size_t values = pattern.col.size() * Dim * Dim;
  require(values <= std::numeric_limits<std::uint32_t>::max(), "SchurFactor::analyze", "number of values",
          values, "less than 2^32");
}

/// Rows, places, values and a factor without fill take more than that of every entry of the triangle. FreeFem++ has an operator new
/// that returns nothing when there is no memory, and throws nothing: what is sure not to fit is refused before.
constexpr double BYTES_PER_ENTRY = 32;

template <int Dim> void check_memory(const NodeBlockMatrix<Dim>& pattern) {
  const double entries = 0.5 * Dim * Dim * static_cast<double>(pattern.col.size());
  require_memory("SchurFactor::analyze",
                 "the matrix of " + std::to_string(pattern.size()) +
                     " unknowns and its factor take more than",
                 BYTES_PER_ENTRY * entries);
}

/// Nodes with a free dof that are not candidates are ordered as a graph of nodes: their dofs share a pattern.
template <int Dim>
void order_dofs(const NodeBlockMatrix<Dim>& pattern, const std::vector<char>& fixed,
                const std::vector<int>& candidates, PermutedTriangle& triangle) {
  std::vector<int> local(pattern.num_nodes, -1), interior;
  std::vector<char> is_candidate(pattern.num_nodes, 0);
  for (int node : candidates) is_candidate[node] = 1;
  for (int node = 0; node < pattern.num_nodes; ++node) {
    bool is_free = false;
    for (int c = 0; c < Dim; ++c) is_free = is_free || !fixed[Dim * node + c];
    if (!is_free || is_candidate[node]) continue;
    local[node] = static_cast<int>(interior.size());
    interior.push_back(node);
  }
  Graph graph;
  for (int node : interior) {
    for (int k = pattern.row_start[node]; k < pattern.row_start[node + 1]; ++k)
      if (local[pattern.col[k]] >= 0) graph.col.push_back(local[pattern.col[k]]);
    graph.row_start.push_back(static_cast<int>(graph.col.size()));
  }
  const auto append_free_dofs = [&](int node) {
    for (int dof = Dim * node; dof < Dim * (node + 1); ++dof)
      if (!fixed[dof]) triangle.order.push_back(dof);
  };
  const auto unknowns = static_cast<int>(std::count(fixed.begin(), fixed.end(), 0));
  const auto [order, halves] = elimination_order(graph, usual_ordering<Dim>, unknowns, Dim);
  std::size_t at = 0;
  for (int half : {0, 1}) {
    for (int k = 0; k < halves[half]; ++k) append_free_dofs(interior[order[at++]]);
    triangle.halves[half] = static_cast<int>(triangle.order.size()) - triangle.halves[0];
  }
  while (at < order.size()) append_free_dofs(interior[order[at++]]);
  triangle.num_interior = static_cast<int>(triangle.order.size());
  for (int node : candidates) append_free_dofs(node);
}

/// Entry (p, q >= p) of the permuted lower triangle takes its value from the lower triangle of the original.
template <int Dim>
void build_lower_triangle(const NodeBlockMatrix<Dim>& pattern, PermutedTriangle& triangle) {
  const std::vector<int> transposed = transposed_blocks(pattern);
  const std::vector<int>& order = triangle.order;
  std::vector<int> position(pattern.size(), -1);
  for (std::size_t p = 0; p < order.size(); ++p) position[order[p]] = static_cast<int>(p);
  const std::size_t most = (pattern.col.size() * Dim * Dim + pattern.size()) / 2; // without fixed dofs
  triangle.col_start.reserve(order.size() + 1);
  triangle.row.reserve(most);
  triangle.slot.reserve(most);
  for (std::size_t p = 0; p < order.size(); ++p) {
    const int dof = order[p], node = dof / Dim, comp = dof % Dim;
    for (int k = pattern.row_start[node]; k < pattern.row_start[node + 1]; ++k) {
      for (int other_comp = 0; other_comp < Dim; ++other_comp) {
        const int other = Dim * pattern.col[k] + other_comp;
        if (position[other] < static_cast<int>(p)) continue;
        if (other == dof && static_cast<int>(p) >= triangle.num_interior)
          triangle.diagonal.push_back(static_cast<int>(triangle.row.size()));
        triangle.row.push_back(position[other]);
        const bool mirrored = other >= dof;
        const std::size_t block = mirrored ? transposed[k] : k;
        const int row_comp = mirrored ? other_comp : comp, col_comp = mirrored ? comp : other_comp;
        triangle.slot.push_back(static_cast<std::uint32_t>((block * Dim + row_comp) * Dim + col_comp));
      }
    }
    triangle.col_start.push_back(static_cast<int>(triangle.row.size()));
  }
}

void check_candidates(int num_nodes, const std::vector<int>& candidates) {
  const char* where = "SchurFactor::analyze";
  std::vector<char> seen(num_nodes, 0);
  for (int node : candidates) {
    require(node >= 0 && node < num_nodes, where, "candidate", node, "0 <= candidate < num_nodes");
    require(!std::exchange(seen[node], 1), where, "candidate", node, "each candidate once");
  }
}

template <int Dim>
void check_arguments(const NodeBlockMatrix<Dim>& pattern, const std::vector<char>& fixed,
                     const std::vector<int>& candidates) {
  check_pattern(pattern);
  check_size(pattern);
  require(fixed.size() == static_cast<std::size_t>(pattern.size()), "SchurFactor::analyze", "fixed.size()",
          fixed.size(), "Dim*num_nodes");
  check_candidates(pattern.num_nodes, candidates);
}

} // namespace

template <int Dim>
void require_permutable(const NodeBlockMatrix<Dim>& pattern, const std::vector<char>& fixed,
                        const std::vector<int>& candidates) {
  check_arguments(pattern, fixed, candidates);
  transposed_blocks(pattern);
}

template <int Dim>
PermutedTriangle permute_candidates_last(const NodeBlockMatrix<Dim>& pattern, const std::vector<char>& fixed,
                                         const std::vector<int>& candidates) {
  check_arguments(pattern, fixed, candidates);
  check_memory(pattern);
  PermutedTriangle triangle;
  order_dofs(pattern, fixed, candidates, triangle);
  build_lower_triangle(pattern, triangle);
  return triangle;
}

template void require_permutable<2>(const NodeBlockMatrix<2>&, const std::vector<char>&,
                                    const std::vector<int>&);
template void require_permutable<3>(const NodeBlockMatrix<3>&, const std::vector<char>&,
                                    const std::vector<int>&);
template PermutedTriangle permute_candidates_last<2>(const NodeBlockMatrix<2>&, const std::vector<char>&,
                                                     const std::vector<int>&);
template PermutedTriangle permute_candidates_last<3>(const NodeBlockMatrix<3>&, const std::vector<char>&,
                                                     const std::vector<int>&);

} // namespace burnish
