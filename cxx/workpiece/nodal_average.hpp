#pragma once
// Quadrature-point fields as nodal fields, for pictures and files.
#include "mesh/discretization.hpp"

namespace burnish {

/// Linear field through the points of each element (constant for one point), averaged at the nodes with the
/// element volumes as weights and kept within the range of the neighboring points.
/// @param values one per quadrature point, any unit; @returns one per node, same unit
/// @throws std::invalid_argument unless values has one entry per quadrature point
Eigen::VectorXd nodal_average(const Discretization<2>& discretization, const Eigen::VectorXd& values);

} // namespace burnish
