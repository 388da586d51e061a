#pragma once
// Radii that sharp edges of a CAD body can be rounded with, found by OpenCASCADE's own fillets.
#include "cad/occ/fillet_radii.hpp"
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

namespace burnish {

/// One radius for all of the edges. It fits if OpenCASCADE makes a valid body of it on which the faces beside the edges are left.
/// Tried from `size` down, halved until one fits, then between that and the last that did not; in a process of its own.
/// @param body  solid or shell that has the edges
/// @param beside faces that must not be used up
/// @param size  radius beyond which nothing can fit
FilletRadii radii_that_fit(const TopoDS_Shape& body, const std::vector<TopoDS_Edge>& edges,
                           const std::vector<TopoDS_Face>& beside, double size);

} // namespace burnish
