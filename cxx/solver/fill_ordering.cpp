#include "solver/fill_ordering.hpp"
#include "solver/cholmod_common.hpp"
#include <metis.h>
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

/// The same with both ends of every edge and without a vertex at its own list.
Graph all_neighbors(const Graph& graph) {
  const Graph upper = upper_triangle(graph);
  std::vector<std::vector<int>> neighbors(graph.size());
  for (int j = 0; j < upper.size(); ++j)
    for (int k = upper.row_start[j]; k < upper.row_start[j + 1]; ++k) {
      const int i = upper.col[k];
      if (i == j) continue;
      neighbors[i].push_back(j);
      neighbors[j].push_back(i);
    }
  Graph all;
  for (const std::vector<int>& of : neighbors) {
    all.col.insert(all.col.end(), of.begin(), of.end());
    all.row_start.push_back(static_cast<int>(all.col.size()));
  }
  return all;
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

/// Order of elimination in its Perm, and in lnz of the common object what its factor would hold. Not for an empty graph.
cholmod_factor* analyzed(const Graph& graph, Ordering ordering, CholmodCommon& common) {
  Graph upper = upper_triangle(graph);
  cholmod_sparse matrix = pattern_of(upper);
  common->supernodal = CHOLMOD_SIMPLICIAL;
  common->postorder = 1;
  common->method[0].ordering = ordering == Ordering::METIS ? CHOLMOD_METIS : CHOLMOD_AMD;
  cholmod_factor* factor = cholmod_analyze(&matrix, common.get());
  if (!factor && common->status == CHOLMOD_NOT_INSTALLED) {
    common->method[0].ordering = CHOLMOD_AMD;
    factor = cholmod_analyze(&matrix, common.get());
  }
  if (!factor) common.check("fill_reducing_order");
  return factor;
}

} // namespace

std::vector<int> fill_reducing_order(const Graph& graph, Ordering ordering) {
  if (graph.size() == 0) return {};
  CholmodCommon common;
  cholmod_factor* factor = analyzed(graph, ordering, common);
  const int* perm = static_cast<const int*>(factor->Perm);
  std::vector<int> order(perm, perm + graph.size());
  cholmod_free_factor(&factor, common.get());
  return order;
}

double factor_fill(const Graph& graph, Ordering ordering) {
  if (graph.size() == 0) return 0;
  CholmodCommon common;
  cholmod_factor* factor = analyzed(graph, ordering, common);
  cholmod_free_factor(&factor, common.get());
  return common->lnz;
}

// METIS would take halves that differ by a fifth, where the separator is smaller: the busier rank decides.
std::vector<int> halves_and_separator(const Graph& graph) {
  constexpr idx_t uneven = 30, cuts = 2; // halves differ by so many thousandths; the best of so many
  std::vector<int> part(graph.size(), SEPARATOR);
  if (part.empty()) return part;
  Graph sides = all_neighbors(graph);
  idx_t options[METIS_NOPTIONS], size = sides.size(), separator = 0;
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_UFACTOR] = uneven;
  options[METIS_OPTION_NSEPS] = cuts;
  if (METIS_ComputeVertexSeparator(&size, sides.row_start.data(), sides.col.data(), nullptr, options,
                                   &separator, part.data()) != METIS_OK)
    throw std::bad_alloc();
  return part;
}

} // namespace burnish
