#pragma once
// Curves of gmsh's own ("built-in") geometry kernel as curves of OpenCASCADE.
#include "cad/occ/cad_edge.hpp"
#include <gp_Pnt.hxx>

namespace burnish {

/// The curves of a text that gmsh wrote as geo_unrolled: points and curves, all with plain numbers. They are what
/// gmsh 4.8.4 evaluates (its GeoInterpolation.cpp, and EndCurve in Geo.cpp), with other parameters:
///   Line             straight, or a chain of straight lines through its points
///   Circle, Ellipse  arc from the first point to the last one about the second, with the radius of the first;
///                    the third point of an ellipse is on an axis of it
///   Spline           Catmull-Rom through its points; beyond its ends the first and the last chord go on
///   BSpline          cubic with equal knots, from its first to its last point; closed: periodic
///   Bezier           one polynomial of all its points, at most 26
///   Nurbs            spline of any order with its knots, from its first to its last point
/// Curves that are none of these are left out.
/// @param middles  a point of each curve near its middle: it tells on which side an arc passes its center
std::map<int, CadEdge> drawn_curves(const std::string& unrolled, const std::map<int, gp_Pnt>& middles);

} // namespace burnish
