#pragma once
// Where a quadrature point is in a state of the workpiece.
#include "workpiece/workpiece.hpp"

namespace burnish {

/// Present position: linear around the nearest node of its element (exact for P1, and for P2 where the points
/// are mid-edge nodes). @param state either state of the workpiece on that mesh [length]
template <int Dim>
Vector<Dim> point_place(const Discretization<Dim>& mesh, int point, const WorkpieceState<Dim>& state);

} // namespace burnish
