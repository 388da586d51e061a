#pragma once
// How the work on the elements is divided among the ranks, and how what they find comes to all of them (ALGORITHMS.md 20).
#include "material/point_step.hpp"
#include "solver/node_block_matrix.hpp"
#include "workpiece/workpiece_state.hpp"

namespace burnish {

/// Points are divided by batches of elements in turn, sums over nodes by rows: a rank sums over all elements of its nodes in the
/// order in which one rank alone does. So the bits do not depend on the number of ranks. A body that is not divided() has
/// all of it on every rank, and nothing is exchanged.
template <int Dim> class ElementDivision {
public:
  /// @param mesh valid; is not kept
  explicit ElementDivision(const Discretization<Dim>& mesh);
  bool divided() const { return m_divided; }

  /// Batches of successive elements; that of number b ends where the next begins.
  int num_batches() const;
  int first_element(int batch) const;
  bool is_mine(int batch) const;
  /// What each rank has found at the points of its batches.
  void share_points(WorkpieceState<Dim>& state, std::vector<PointTrial>& trial) const;
  /// The failure of the first point of all. @param point of this rank's first failure, -1: none; in and out, with the others
  /// @returns its batch, -1: no point failed
  int share_failure(int& point, UpdateStatus& status, double& value) const;

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
