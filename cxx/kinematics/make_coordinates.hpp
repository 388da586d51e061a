#pragma once
// Coordinates of a tool as a script names them.
#include "base/arguments.hpp"
#include "kinematics/coordinates.hpp"
#include <memory>

namespace burnish {

/// Parameters of all kinds, in the plane and in space, each name once.
const std::vector<Parameter>& coordinate_parameters();

/// In the plane
///   "cartesian"   x, y, angle
///   "polar"       r, phi, theta about pivot=[x0,y0]
///   "a, b, ..."   names of one's own, with the formulas x=, y=, angle=
/// in space
///   "cartesian"   x, y, z, spinx, spiny, spinz (CartesianInSpace); with rotation= x, y, z and every name of its formulas that
///                 is no parameter, in their order: rotation="z:phi x:theta z:psi", "vector: a, b, c", "quaternion: w, a, b, c"
///   "polar"       r, phi, z, theta about the line through pivot=[x0,y0,z0] along axis=[x,y,z] (PolarInSpace); phi = 0 is
///                 along x of the frame that is turned the shortest way from z to the axis
///   "screw"       phi: the turn about that line, and lead= along it a turn (Screw)
///   "a, b, ..."   names of one's own, with the formulas x=, y=, z=, rotation=
/// All of them with size= (SizedCoordinates): every name of its formula that is no parameter is a coordinate, behind the others.
/// @param tool       its name, for messages
/// @param parameters numbers that formulas call by name
/// @param following  names of parameters that follow t: coordinates, too
/// @throws std::invalid_argument "tool.coordinates: ..." for an unknown kind, a parameter of another kind or dimension, one that
/// is missing, a wrong number of values; and what the kinds refuse
template <int Dim>
std::shared_ptr<const Coordinates<Dim>> make_coordinates(const std::string& tool, const std::string& kind,
                                                         const Arguments& given,
                                                         const std::map<std::string, double>& parameters,
                                                         const std::vector<std::string>& following = {});

} // namespace burnish
