#pragma once
// Quantities of state() at all quadrature points, for scripts and files.
#include "workpiece/workpiece.hpp"

namespace burnish {

/// An internal variable of the law [its unit]; num_points. @param component of a symmetric tensor, in the order of Stress
/// @throws std::invalid_argument if the law has no such variable (lists those it has), or no such component
template <int Dim>
Eigen::VectorXd internal_field(const Workpiece<Dim>& body, const std::string& name, int component = 0);
/// Von Mises stress of the Kirchhoff stress that the points carry [stress]; num_points.
template <int Dim> Eigen::VectorXd stress_eq_field(const Workpiece<Dim>& body);
/// q/sigma_y - 1, of the effective stress: positive outside the yield surface, where only forward Euler leads [-]; of a
/// point, 0 <= point < num_points, the largest, and of all.
template <int Dim> double yield_distance(const Workpiece<Dim>& body, int point);
template <int Dim> double largest_yield_distance(const Workpiece<Dim>& body);
template <int Dim> Eigen::VectorXd yield_distance_field(const Workpiece<Dim>& body);
/// Integrity [-], 1 where no damage is defined; Kirchhoff stress that the points carry, num_points x num_stress [stress].
template <int Dim> Eigen::VectorXd integrity_field(const Workpiece<Dim>& body);
template <int Dim> std::vector<double> stress_field(const Workpiece<Dim>& body);
/// Kirchhoff stress for a script: of a user-defined law what it gave, else that which the points carry.
template <int Dim> std::vector<double> script_stress_field(const Workpiece<Dim>& body);
/// Cauchy stress that the points carry, tau / det F; with small strains the stress itself; num_points x num_stress [stress].
template <int Dim> std::vector<double> cauchy_field(const Workpiece<Dim>& body);
/// sigma_y and its slope [stress] of the law at the given plastic strains, one per point.
/// @throws std::invalid_argument for a wrong size, or a law without a yield stress
template <int Dim>
Eigen::VectorXd yield_stress_field(const Workpiece<Dim>& body, const Eigen::VectorXd& plastic_strain_eq);
template <int Dim>
Eigen::VectorXd hardening_slope_field(const Workpiece<Dim>& body, const Eigen::VectorXd& plastic_strain_eq);
/// First Piola stress, num_points x num_gradient, row-major [stress].
template <int Dim> std::vector<double> piola_field(const Workpiece<Dim>& body);
/// Its symmetrized tangent dP_i/dF_j, num_points x num_gradient x num_gradient, row-major [stress].
template <int Dim>
std::vector<double> moduli_field(const Workpiece<Dim>& body, TangentKind kind, double elastic_blend = 0);
/// Increments of the step that the last update made (StepIncrements): strains, then rotations, num_points x num_increments,
/// row-major [-]. Zero right after accept and revert.
template <int Dim> std::vector<double> increments_field(const Workpiece<Dim>& body);

} // namespace burnish
