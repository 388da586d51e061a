#pragma once
// The list of what the plugin registers, and the words of its types.
#include <string>

namespace burnish {

/// Before the first registration: global names that are not ours.
void note_names_before();
/// After the last one.
void register_callables();

/// FreeFEM's type in the words of a script: "int[int]". @param name  type_info::name() of it
std::string type_name(const char* name);

} // namespace burnish
