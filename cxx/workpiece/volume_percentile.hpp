#pragma once
// A largest value that does not hang on one point.
#include "mesh/discretization.hpp"

namespace burnish {

/// Value below which a share of the volume lies, of those points only whose value is above `least`; 0 if there are none.
/// @param values one per quadrature point, any unit; @param share 0..1
/// @returns a value of one of the points, same unit
/// @throws std::invalid_argument for a wrong size or share
template <int Dim>
double volume_percentile(const Discretization<Dim>& discretization, const Eigen::VectorXd& values,
                         double share, double least);

} // namespace burnish
