#pragma once
// Square sparse matrix of Dim x Dim node blocks, rows sorted: the form in which the workpiece's tangent is
// kept.
#include "base/types.hpp"
#include <vector>

namespace burnish {

/// Fixed pattern, values replaced at will. Degree of freedom = Dim*node + component.
/// The pattern is structurally symmetric and contains every diagonal block.
template <int Dim> struct NodeBlockMatrix {
  int num_nodes = 0;
  std::vector<int> row_start; ///< num_nodes + 1
  std::vector<int> col;       ///< neighbor nodes, ascending in each row
  std::vector<double> value;  ///< Dim*Dim per block, row-major within a block

  int size() const { return Dim * num_nodes; }
  /// Index of block (row, col) or -1 if the pattern has none there (or row is out of range).
  int find(int row, int col_node) const;
  double* block(int k) { return value.data() + static_cast<std::size_t>(k) * Dim * Dim; }
  const double* block(int k) const { return value.data() + static_cast<std::size_t>(k) * Dim * Dim; }
  /// y = A x.
  /// @throws std::invalid_argument if x is not of size()
  Eigen::VectorXd multiply(const Eigen::VectorXd& x) const;
};

/// Pattern from element connectivity (num_elements x nodes_per_element, row-major), values zero.
/// Nodes of no element get their diagonal block only.
/// @throws std::invalid_argument if a node is out of range or connectivity is not made of whole elements
template <int Dim>
NodeBlockMatrix<Dim> pattern_from_elements(int num_nodes, int nodes_per_element,
                                           const std::vector<int>& connectivity);

/// Coordinate-format matrix as a host program keeps it (0-based; `half`: one triangle only, either one).
struct TripletView {
  int n = 0;
  std::size_t nnz = 0;
  const int* row = nullptr;
  const int* col = nullptr;
  const double* value = nullptr;
  bool half = false;
};

/// Copies triplets into a NodeBlockMatrix. The slot of every triplet is cached and reused while the
/// triplets' rows and columns stay the same (compared each time). Repeated triplets are added; blocks that
/// the triplets lack for a structurally symmetric pattern with every diagonal block are zero.
template <int Dim> class TripletReader {
public:
  /// The matrix returned lives in the reader and is overwritten by the next call; an exception leaves it
  /// unchanged.
  /// @throws std::invalid_argument if n is not Dim*nodes, an index is out of range, a value is not finite
  /// (row, column and value are named), or a half matrix has entries on both sides of the diagonal
  const NodeBlockMatrix<Dim>& read(const TripletView& triplets);
  int builds() const { return m_builds; } ///< times that pattern and slots were built anew

private:
  void build(const TripletView& triplets);
  NodeBlockMatrix<Dim> m_matrix;
  std::vector<int> m_row, m_col;
  std::vector<std::size_t> m_slot, m_slot_mirror;
  bool m_half = false;
  int m_builds = 0;
};

} // namespace burnish
