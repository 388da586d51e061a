#pragma once
// Quantities of state() at all quadrature points, for scripts and files.
#include "workpiece/workpiece.hpp"

namespace burnish {

/// Von Mises stress [stress]; q/sigma_y - 1 [-]; num_points.
template <int Dim> Eigen::VectorXd stress_eq_field(const Workpiece<Dim>& body);
template <int Dim> Eigen::VectorXd yield_distance_field(const Workpiece<Dim>& body);
/// First Piola stress, num_points x num_gradient, row-major [stress].
template <int Dim> std::vector<double> piola_field(const Workpiece<Dim>& body);
/// Its symmetrized tangent dP_i/dF_j, num_points x num_gradient x num_gradient, row-major [stress].
template <int Dim> std::vector<double> moduli_field(const Workpiece<Dim>& body, TangentKind kind);

} // namespace burnish
