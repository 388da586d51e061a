#include "solver/fill_ordering.hpp"
#include "solver/cholmod_common.hpp"
#include <utility>

namespace burnish {

namespace {

/// Upper triangle by columns: column j holds its neighbors i <= j, edges listed at one end included, once
/// each.
Graph upper_triangle(const Graph& graph) {
  const int n = graph.size();
  std::vector<std::vector<int>> columns(n);
  std::vector<int> mark(n, -1);
  for (int i = 0; i < n; ++i)
    for (int k = graph.row_start[i]; k < graph.row_start[i + 1]; ++k) {
      const int j = graph.col[k];
      if (j < 0 || j >= n) throw std::runtime_error("fill_reducing_order: neighbor out of range");
      columns[i > j ? i : j].push_back(i > j ? j : i);
    }
  Graph upper;
  for (int j = 0; j < n; ++j) {
    for (int i : columns[j])
      if (std::exchange(mark[i], j) != j) upper.col.push_back(i);
    upper.row_start.push_back(static_cast<int>(upper.col.size()));
  }
  return upper;
}

cholmod_sparse pattern_of(Graph& upper) {
  cholmod_sparse matrix{};
  matrix.nrow = matrix.ncol = upper.size();
  matrix.nzmax = upper.col.size();
  matrix.p = upper.row_start.data();
  matrix.i = upper.col.data();
  matrix.stype = 1;
  matrix.itype = CHOLMOD_INT;
  matrix.xtype = CHOLMOD_PATTERN;
  matrix.dtype = CHOLMOD_DOUBLE;
  matrix.sorted = 0;
  matrix.packed = 1;
  return matrix;
}

} // namespace

std::vector<int> fill_reducing_order(const Graph& graph, Ordering ordering) {
  const int n = graph.size();
  if (n == 0) return {};
  Graph upper = upper_triangle(graph);
  cholmod_sparse matrix = pattern_of(upper);
  CholmodCommon common;
  common->supernodal = CHOLMOD_SIMPLICIAL;
  common->postorder = 1;
  common->method[0].ordering = ordering == Ordering::METIS ? CHOLMOD_METIS : CHOLMOD_AMD;
  cholmod_factor* factor = cholmod_analyze(&matrix, common.get());
  if (!factor && common->status == CHOLMOD_NOT_INSTALLED) {
    common->method[0].ordering = CHOLMOD_AMD;
    factor = cholmod_analyze(&matrix, common.get());
  }
  if (!factor) common.check("fill_reducing_order");
  const int* perm = static_cast<const int*>(factor->Perm);
  std::vector<int> order(perm, perm + n);
  cholmod_free_factor(&factor, common.get());
  return order;
}

std::vector<int> halves_and_separator(const Graph& graph) {
  std::vector<int> part(graph.size(), SEPARATOR);
  if (part.empty()) return part;
  Graph upper = upper_triangle(graph);
  cholmod_sparse matrix = pattern_of(upper);
  CholmodCommon common;
  constexpr int compress = 1; // vertices with the same neighbors go together
  if (cholmod_bisect(&matrix, nullptr, 0, compress, part.data(), common.get()) >= 0) return part;
  if (common->status != CHOLMOD_NOT_INSTALLED) common.check("halves_and_separator");
  return std::vector<int>(part.size(), 0);
}

} // namespace burnish
