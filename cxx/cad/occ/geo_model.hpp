#pragma once
// Curves of a .geo file: gmsh runs its commands, OpenCASCADE evaluates what they draw.
#include "cad/gmsh_library.hpp"
#include "cad/occ/cad_edge.hpp"

namespace burnish {

/// The curves of a .geo file, each compared with points of it that gmsh gives.
/// @param seconds  of computing that gmsh may take
/// @throws std::invalid_argument with the file and what gmsh says of it, or how it broke down
CadModel read_geo(const std::string& path, const GeoNumbers& numbers, double seconds);

} // namespace burnish
