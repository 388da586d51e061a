#pragma once
// Meshes of parametrized .geo files, made by gmsh.
#include "cad/gmsh_library.hpp"

namespace burnish {

/// Meshes a .geo file of the plane z = 0 with triangles, or one of volumes with tetrahedra, and writes result.msh, of format
/// MSH 2.2, and result.log, what gmsh prints on the way; folders that lack are made. Physical curves of the file give the
/// labels of its edges, physical surfaces the regions; in space those of surfaces and volumes. What the file runs is not
/// limited in time: Ctrl-C ends it.
/// @param numbers  "R=10e-3; H=2e-3" for the DefineConstants of the file, or ""
/// @throws std::invalid_argument with the file: missing, no .geo, a number whose name it does not have or
/// overwrites, what gmsh says of it, no triangles, no physical curves (in space no tetrahedra, no physical surfaces). Then
/// there is no result.msh.
void mesh_geo(const std::string& file, const std::string& numbers, const std::string& result,
              const GeoMeshing& meshing = {});

} // namespace burnish
