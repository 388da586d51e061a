#pragma once
// Fill-reducing orders of symmetric graphs.
#include <array>
#include <vector>

namespace burnish {

/// Symmetric graph by adjacency lists: neighbors of i are col[row_start[i] .. row_start[i+1]). Each edge may
/// be listed at one of its ends or at both, a vertex may list itself.
struct Graph {
  std::vector<int> row_start{0};
  std::vector<int> col;
  int size() const { return static_cast<int>(row_start.size()) - 1; }
};

enum class Ordering {
  AMD,  ///< approximate minimum degree: plane problems
  METIS ///< nested dissection: problems in space; AMD if CHOLMOD was built without METIS
};

/// The one with less fill for bodies of that dimension.
template <int Dim> inline constexpr Ordering usual_ordering = Ordering::METIS;
template <> inline constexpr Ordering usual_ordering<2> = Ordering::AMD;

/// Order of elimination with little fill, postordered (a column stands close to its parent in the elimination
/// tree, as supernodes need it).
/// @return order[k] = vertex eliminated at k; empty for an empty graph
/// @throws std::bad_alloc, std::runtime_error on a CHOLMOD error (a neighbor out of range)
std::vector<int> fill_reducing_order(const Graph& graph, Ordering ordering);

/// Numbers in the triangular factor of a matrix of that graph in that order, one a vertex and one an edge, filled ones too.
/// @throws as fill_reducing_order
double factor_fill(const Graph& graph, Ordering ordering);

/// An order of elimination of a body that two ranks may divide.
struct EliminationOrder {
  std::vector<int> order; ///< order[k] = vertex eliminated at k
  std::array<int, 2> halves{
      0,
      0}; ///< vertices of the two halves, which come first; then what separates them. 0 of an undivided body
};

/// Two halves without an edge between them, by METIS; the larger has a few per cent more vertices at most where the graph allows it.
/// @return per vertex its half, 0 or 1, or SEPARATOR
/// @throws as fill_reducing_order
std::vector<int> halves_and_separator(const Graph& graph);
inline constexpr int SEPARATOR = 2;

} // namespace burnish
