#pragma once
// Quadrature-point fields as nodal fields, for pictures and files.
#include "mesh/discretization.hpp"
#include <vector>

namespace burnish {

/// Nodal values of fields over the quadrature points, for many fields on one mesh: at each node that of the linear field
/// that fits the points of the node's elements in least squares, kept within their range; their mean where fewer than
/// Dim + 2 points, or points (almost) in one plane (in the plane: on a line), leave the fit open.
template <int Dim> class NodalFit {
public:
  explicit NodalFit(const Discretization<Dim>& discretization);
  /// @param values one per quadrature point, any unit; @returns one per node, same unit; 0 at a node of no element
  /// @param within false: beyond their range too, so that a linear field is recovered as it is
  /// @throws std::invalid_argument unless values has one entry per quadrature point
  Eigen::VectorXd operator()(const Eigen::VectorXd& values, bool within = true) const;

private:
  void add_weights(const Discretization<Dim>& discretization, int node);
  double at(int node, const Eigen::VectorXd& values, bool within) const;
  int m_num_values;
  std::vector<int> m_begin, m_point; // points of node n: m_point[m_begin[n] .. m_begin[n + 1])
  std::vector<double> m_weight;      // of each of them
  std::vector<char> m_has_fit;       // per node; 0: the mean
};

/// The same for one field.
template <int Dim>
Eigen::VectorXd nodal_average(const Discretization<Dim>& discretization, const Eigen::VectorXd& values,
                              bool within = true);

/// The linear function of every element with the given values at its quadrature points, by its values at 3 places per
/// element (triangles with 3 points): on the way from the centroid to the vertices, `share` of it; one number per
/// element where there is one point. Unit of the values.
/// @throws std::invalid_argument for a wrong size or another quadrature than that of triangles()
Eigen::VectorXd vertex_values(const Discretization<2>& mesh, const Eigen::VectorXd& values, double share = 1);

} // namespace burnish
