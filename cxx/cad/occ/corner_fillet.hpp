#pragma once
// Radii that a corner between two curves of the plane can be rounded with.
#include "cad/occ/cad_piece.hpp"
#include "cad/occ/fillet_radii.hpp"

namespace burnish {

/// An arc fits that is tangent to both curves before they end, with its center on the inner side of the corner and no other
/// point of the two closer to it. Its tangent points are found by Newton's method, the radius growing from 0.
/// @param before, after  a corner where the first ends and the second begins; twice the same: where it closes
FilletRadii radii_that_fit(const CadPiece& before, const CadPiece& after);

} // namespace burnish
