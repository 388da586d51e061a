#pragma once
// Quadrature-point fields as nodal fields, for pictures and files.
#include "mesh/discretization.hpp"

namespace burnish {

/// Value at each node of the linear field that fits the points of the node's elements in least squares, kept
/// within their range; their mean where fewer than Dim + 2 points, or points (almost) in one plane (in the
/// plane: on a line), leave the fit open.
/// @param values one per quadrature point, any unit; @returns one per node, same unit
/// @param within false: beyond their range too, so that a linear field is recovered as it is
/// @throws std::invalid_argument unless values has one entry per quadrature point
template <int Dim>
Eigen::VectorXd nodal_average(const Discretization<Dim>& discretization, const Eigen::VectorXd& values,
                              bool within = true);

/// The linear function of every element with the given values at its quadrature points, by its values at 3 places per
/// element (triangles with 3 points): on the way from the centroid to the vertices, `share` of it; one number per
/// element where there is one point. Unit of the values.
/// @throws std::invalid_argument for a wrong size or another quadrature than that of triangles()
Eigen::VectorXd vertex_values(const Discretization<2>& mesh, const Eigen::VectorXd& values, double share = 1);

} // namespace burnish
