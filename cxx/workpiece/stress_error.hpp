#pragma once
// How much finer the stress varies than the mesh: its nodal recovery against the stress itself [ZienkiewiczZhu1992].
#include "workpiece/nodal_average.hpp"

namespace burnish {

struct StressError {
  Eigen::VectorXd point; ///< Frobenius norm of the difference at every quadrature point [stress]
  double relative = 0;   ///< norm of the difference over that of the recovered stress, over the volume [-]
  int worst = 0;         ///< element that contributes most
};

/// @param stress num_points x num_stress, in the order of Stress [stress]
/// @throws std::invalid_argument unless there are so many numbers
template <int Dim>
StressError stress_error(const Discretization<Dim>& discretization, const std::vector<double>& stress);
/// @param fit that of the discretization
template <int Dim>
StressError stress_error(const Discretization<Dim>& discretization, const NodalFit<Dim>& fit,
                         const std::vector<double>& stress);

} // namespace burnish
