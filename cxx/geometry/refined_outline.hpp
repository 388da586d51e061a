#pragma once
// The outline of a surface, finer where it bends.
#include "geometry/surface.hpp"
#include <functional>

namespace burnish {

/// Places of a mesh along a profile before it is refined.
inline constexpr int MESH_PLACES = 49;

/// Places of the outline from its begin to its end, with the joints of its pieces, in the order of travel; intervals are
/// halved until the curve is near its chords.
/// @param first   number of places at the beginning, before the joints
/// @param allowed largest distance from the chord between two points of the outline (in the surface's frame) [length]
template <int Dim>
std::vector<SurfacePlace<Dim>>
refined_outline(const Surface<Dim>& surface, int first,
                const std::function<double(const Vector<Dim>&, const Vector<Dim>&)>& allowed);

} // namespace burnish
