#pragma once
// How the work on the elements is divided among the ranks, and how what they find comes to all of them (ALGORITHMS.md 20).
#include "mesh/discretization.hpp"
#include "solver/node_block_matrix.hpp"

namespace burnish {

/// Sums over nodes are divided by rows: a rank sums over all elements of its nodes in the order in which one rank alone does, so
/// the bits do not depend on the number of ranks. A body that is not divided() has all of it on every rank, and nothing is
/// exchanged.
template <int Dim> class ElementDivision {
public:
  /// @param mesh valid; is not kept
  explicit ElementDivision(const Discretization<Dim>& mesh);

  /// Calls f for the points of all elements at this rank's nodes, ascending.
  template <class F> void for_points(F&& f) const {
    const int per_element = m_points_per_element;
    const int count = m_divided ? static_cast<int>(m_elements.size()) : m_num_elements;
    for (int k = 0; k < count; ++k) {
      const int e = m_divided ? m_elements[k] : k;
      for (int p = e * per_element; p < (e + 1) * per_element; ++p) f(p);
    }
  }
  /// Rows of each rank's nodes, of num_dofs numbers, or of a matrix with the pattern of the mesh.
  void share_rows(Eigen::VectorXd& values) const;
  void share_rows(NodeBlockMatrix<Dim>& matrix) const;

private:
  void divide_nodes(const Discretization<Dim>& mesh);
  template <class Place> void share(double* values, Place&& place) const;

  bool m_divided = false;
  int m_num_elements = 0, m_points_per_element = 0;
  std::vector<int> m_nodes;           // rank by rank
  std::vector<std::size_t> m_of_rank; // where those of a rank begin
  std::vector<int> m_elements;        // of this rank's nodes, ascending
};

} // namespace burnish
