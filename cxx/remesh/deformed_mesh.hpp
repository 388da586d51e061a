#pragma once
// The workpiece where it is now, as a mesh: its places, its volume, how good its elements are.
#include "workpiece/workpiece.hpp"

namespace burnish {

/// The same mesh with nodes and quadrature points where they are at u; weights and gradients stay those of the reference.
/// @param u displacement, num_dofs [length]
template <int Dim> Discretization<Dim> deformed(Discretization<Dim> mesh, const Eigen::VectorXd& u);

/// Volume of the accepted state, of a plane body its area, of an axisymmetric one that of the ring [length^Dim, length^3].
template <int Dim> double deformed_volume(const Workpiece<Dim>& body);

/// Shape of the worst element of the accepted state, ALGORITHMS.md (19.1) [-]: 1 equilateral, 0 flat.
template <int Dim> double least_shape(const Workpiece<Dim>& body);
/// The same of the reference configuration.
template <int Dim> double reference_shape(const Discretization<Dim>& mesh);

} // namespace burnish
