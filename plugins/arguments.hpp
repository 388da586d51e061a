#pragma once
// Named parameters of a call as a table of the core lists them.
#include "base/arguments.hpp"
#include "named.hpp"

namespace burnish {

/// The entries of names[] for these parameters, with `more` ones after them. The list must outlive FreeFEM's use of it.
std::vector<basicAC_F0::name_and_type> names_of(const std::vector<Parameter>& list,
                                                const std::vector<basicAC_F0::name_and_type>& more);
/// Those that the call gave.
Arguments arguments_of(const Named& named, const std::vector<Parameter>& list);

} // namespace burnish
