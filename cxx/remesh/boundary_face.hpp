#pragma once
// A triangle of the surface where it is now: flat through 3 nodes, or the quadratic one through 6.
#include "base/types.hpp"
#include "mesh/simplex.hpp"
#include <utility>
#include <vector>

namespace burnish {

/// 3 or 6 nodes, in the order of nodes_of [length].
using FaceNodes = std::vector<Vector<3>>;

/// Place at barycentric coordinates l [length].
Vector<3> place_on(const FaceNodes& x, const Barycentric<2>& l);
/// Its place nearest to p, and the squared distance [length^2].
std::pair<Vector<3>, double> nearest_on(const FaceNodes& x, const Vector<3>& p);
/// Volume between the face and the origin, positive where the origin is behind it: of a closed surface the sum is what it
/// encloses [length^3].
double volume_behind(const FaceNodes& x);

} // namespace burnish
