#pragma once
// Named parameters of a tool that choose its profile, from the core's table of shapes.
#include "geometry/surface.hpp"
#include "named.hpp"
#include "shapes/shapes.hpp"
#include <variant>

namespace burnish {

/// The entries of names[] for shape_of(), with `more` ones after them.
std::vector<basicAC_F0::name_and_type> shape_names(const std::vector<basicAC_F0::name_and_type>& more);

/// Of the plane or of space, as the kind of shape says.
using AnySurface = std::variant<std::shared_ptr<const Surface<2>>, std::shared_ptr<const Surface<3>>>;
/// @throws std::invalid_argument see make_shape
AnySurface shape_of(const Named& named);

} // namespace burnish
