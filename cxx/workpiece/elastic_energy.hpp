#pragma once
// Elastic energy that a workpiece has stored.
#include "workpiece/workpiece.hpp"

namespace burnish {

/// Of the accepted state, sum of V (s:s/(4 G) + p^2/(2 K)) over the points, METHOD.md 3.17; that of the effective stress times
/// the integrity [force length]. NaN of a law that does not know G and K.
template <int Dim> double elastic_energy(const Workpiece<Dim>& body);

} // namespace burnish
