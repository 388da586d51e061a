#pragma once
// All kinds of tool profiles that a script can name.
#include "geometry/shape_kind.hpp"

namespace burnish {

/// The table. A new kind: its own source file, and one line here.
const std::vector<ShapeKind>& shape_kinds();

/// Parameters of all kinds, each name once.
std::vector<Parameter> shape_parameters();

/// The profile that the arguments name.
/// @throws std::invalid_argument for none or several kinds, for a parameter of another kind, and what the
/// profile refuses
std::shared_ptr<const Profile<2>> make_shape(const Arguments& arguments);

/// Every kind with its parameters, a line each.
std::string shape_help();

} // namespace burnish
