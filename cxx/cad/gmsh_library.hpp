#pragma once
// gmsh, opened when it is first needed and run in a process of its own: see cad/companion_gmsh/burnish_gmsh.h.
#include "cad/companion_gmsh/burnish_gmsh.h"
#include <map>
#include <string>

namespace burnish {

/// Numbers for the DefineConstants of a .geo file.
using GeoNumbers = std::map<std::string, double>;

/// "R=10e-3; H=2e-3" (separated by ; or ,) as names and values.
/// @throws std::invalid_argument for anything else, and for a name given twice
GeoNumbers parse_numbers(const std::string& where, const std::string& text);

/// What gmsh says of a .geo file: "" if all is well, else its error, or how it broke down.
/// @param folder   gets the files of burnish_gmsh_curves
/// @param seconds  of computing that reading may take
/// @throws std::invalid_argument if the library is not there
std::string gmsh_curves(const std::string& file, const GeoNumbers& numbers, const std::string& folder,
                        double seconds);

/// What of a .geo file is meshed, and how fine.
struct GeoMeshing {
  int dimension = 2;      ///< 2: surfaces, 3: volumes
  std::string sizes = ""; ///< statements of .geo that set the lengths of edges; "": those of the file
};

/// The same of meshing it. @param result  the .msh file
/// @param log  file for what gmsh prints on the way
std::string gmsh_mesh(const std::string& file, const GeoNumbers& numbers, const std::string& result,
                      const std::string& log, const GeoMeshing& meshing);

/// The same of filling a body with tetrahedra, see burnish_gmsh_fill. @param result the file that it writes
std::string gmsh_fill(const burnish_gmsh_body& body, const std::string& result, const std::string& log);

} // namespace burnish
