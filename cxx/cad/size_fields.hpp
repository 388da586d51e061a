#pragma once
// Lengths of edges by gmsh's size fields: fine in some balls, growing around them.
#include <string>
#include <vector>

namespace burnish {

/// A ball with edges of one length.
struct SizeZone {
  double center[3]; ///< [length]
  double radius;    ///< [length]
  double
      length; ///< of the edges there; gmsh keeps to it on surfaces, its tetrahedra have some a quarter longer [length]
};

/// Statements of .geo for L = min(coarse, length + growth (distance to the ball)) over all zones, in place of what a file says
/// of lengths. @param growth of the length over the distance [-]; @param coarse longest edges [length]
/// @throws std::invalid_argument "where: ..." unless there are zones, all numbers are finite, 0 < length < coarse, radius >
///         0, growth > 0, and one zone with what is around it makes no more than five million tetrahedra
std::string size_fields(const std::vector<SizeZone>& zones, double coarse, double growth, const char* where);

} // namespace burnish
