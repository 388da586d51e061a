#pragma once
// Shared libraries of our own that are opened when they are first needed: what they are linked with costs nothing before.

namespace burnish {

/// Opens a library beside the plugin, or in the folder plugins beside the one of a test program; never closed.
/// @param name   of the file
/// @param what   that it brings, for the message: "gmsh"
/// @param needs  Debian's package that it is linked with
/// @returns handle for dlsym; @throws std::invalid_argument if it cannot be opened
void* open_companion(const char* name, const char* what, const char* needs);

/// The address of a function of such a library. @throws std::invalid_argument if there is none of this name
void* companion_function(void* library, const char* name, const char* function);

} // namespace burnish
