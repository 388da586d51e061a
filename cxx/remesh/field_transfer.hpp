#pragma once
// Fields over the quadrature points of one mesh at places of another one (METHOD.md 1.17).
#include "mesh/discretization.hpp"
#include <vector>

namespace burnish {

/// For many fields: at each place the linear field that fits the points around it in least squares, the nearer a point the
/// more it counts, METHOD.md (1.42); beyond the range of these points by at most half of it.
template <int Dim> class FieldTransfer {
public:
  /// @param from  mesh whose points have the values, at the places that count
  /// @param to    places; outside the mesh the nearest element counts
  /// @throws std::invalid_argument for a place that is farther from every point than `far` times the size of the element there
  FieldTransfer(const Discretization<Dim>& from, const std::vector<Vector<Dim>>& to);
  /// @param values one per point of the mesh, any unit; @returns one per place, same unit
  /// @throws std::invalid_argument for another size
  Eigen::VectorXd operator()(const Eigen::VectorXd& values) const;
  /// The point nearest to each place.
  const std::vector<int>& nearest() const { return m_nearest; }

private:
  void add_weights(const Discretization<Dim>& from, const Vector<Dim>& x, const std::vector<int>& patch);
  int m_num_values;
  std::vector<int> m_nearest;
  std::vector<int> m_begin, m_point; // points around place k: m_point[m_begin[k] .. m_begin[k + 1])
  std::vector<double> m_weight;      // of each of them
};

/// A nodal field at places: linear in the element at each of them.
/// @param from  mesh with its nodes at the places that count; @param values num_nodes x Dim
/// @returns as long as `to` times Dim
template <int Dim>
Eigen::VectorXd nodal_transfer(const Mesh<Dim>& from, const Eigen::VectorXd& values,
                               const std::vector<Vector<Dim>>& to);

} // namespace burnish
