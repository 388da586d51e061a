#pragma once
// Named parameters of a tool that choose its profile, from the core's table of shapes.
#include "named.hpp"
#include "shapes/shapes.hpp"

namespace burnish {

/// The entries of names[] for shape_of(), with `more` ones after them.
std::vector<basicAC_F0::name_and_type> shape_names(const std::vector<basicAC_F0::name_and_type>& more);

/// @throws std::invalid_argument see make_shape
std::shared_ptr<const Profile<2>> shape_of(const Named& named);

} // namespace burnish
