#pragma once
// A named parameter that takes numbers either way: inline, [1, 2, 3], or as real[int] or int[int].
#include "plugin.hpp"

namespace burnish {

/// FreeFEM itself casts no inline array to real[int]. In names[]: &typeid(NumberList*); see Named::numbers.
struct NumberList {
  std::vector<double> values;
};

void register_number_list();

} // namespace burnish
