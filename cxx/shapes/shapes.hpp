#pragma once
// All kinds of tool profiles and surfaces that a script can name.
#include "geometry/shape_kind.hpp"

namespace burnish {

/// The profiles of the plane. A new kind: its own source file, and one line here.
const std::vector<ShapeKind>& shape_kinds();
/// The surfaces of space: those with a name, and profiles that are turned or swept.
const std::vector<SurfaceKind>& surface_kinds();

/// Parameters of all kinds, of the plane and of space, each name once.
std::vector<Parameter> shape_parameters();

/// 3 if the arguments name a surface of space, or a CAD file with faces in space and nothing else, else 2.
int shape_dimension(const Arguments& arguments);

/// The profile that the arguments name.
/// @throws std::invalid_argument for none or several kinds, for a parameter of another kind, and what the
/// profile refuses
std::shared_ptr<const Profile<2>> make_shape(const Arguments& arguments);

/// The surface that the arguments name: in the plane that of a profile.
/// @throws std::invalid_argument as make_shape
template <int Dim> std::shared_ptr<const Surface<Dim>> make_surface(const Arguments& arguments);

/// Every kind with its parameters, a line each.
std::string shape_help();

} // namespace burnish
