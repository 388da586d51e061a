#pragma once
// Bodies and curves of .step and .brep files, read by OpenCASCADE itself.
#include "cad/occ/cad_edge.hpp"
#include <TopoDS_Shape.hxx>
#include <vector>

namespace burnish {

/// All that is in a .step, .stp or .brep file. The last one is remembered: it is read again only if it has changed.
/// @throws std::invalid_argument with the file and the first thing that is wrong with it: it is damaged, cut
/// short, has a value that is no number, refers to what is not there, or parts of it were lost
TopoDS_Shape read_topology(const std::string& path);

/// The curves of a .step, .stp or .brep file. Edges have the numbers that gmsh gives them: those of solids first,
/// then of other faces, then free ones, each once. STEP files arrive in mm, whatever their unit.
/// @throws std::invalid_argument as read_topology
CadModel read_shape(const std::string& path);

/// The parts of the compound in a .brep file, if they are edges.
/// @throws std::invalid_argument as read_topology
std::vector<CadEdge> read_edges(const std::string& path);

} // namespace burnish
