#pragma once
// What a script names of a CAD file.
#include "geometry/shape_kind.hpp"
#include <string>
#include <vector>

namespace burnish {

/// What to take from a file.
struct CadSelection {
  std::string file;
  std::vector<int> curves;     ///< tags as gmsh numbers them; empty: all
  double scale = 1;            ///< tool's unit of length per unit of the file; STEP files arrive in mm
  std::string numbers;         ///< "R=10e-3; H=2e-3" for the DefineConstants of a .geo file
  bool inside = false;         ///< body on the other side
  double seconds = 10;         ///< of computing that gmsh may take over a .geo file
  std::vector<int> faces = {}; ///< numbers of faces, in space; empty: all
  bool side_given = false;     ///< whether the script says on which
};

/// "cad="file"" in scripts.
ShapeKind cad_curve_shape();
/// "faces=[1,2] with cad="file"" in scripts.
SurfaceKind cad_face_shape();
/// Whether cad= alone means a tool of space: the file can be read and has a face that is not in the plane z = 0.
bool has_cad_faces(const std::string& file);

} // namespace burnish
