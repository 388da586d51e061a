#pragma once
// Where a quadrature point is in a state of the workpiece.
#include "workpiece/workpiece.hpp"

namespace burnish {

/// Present position, sum N_a (X_a + u_a). @param state either state of the workpiece on that mesh [length]
template <int Dim>
Vector<Dim> point_place(const Discretization<Dim>& mesh, int point, const WorkpieceState<Dim>& state);

} // namespace burnish
