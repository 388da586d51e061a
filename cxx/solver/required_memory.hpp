#pragma once
// What a factor needs is said before it is begun, not by the system's end of the process.
#include <string>

namespace burnish {

/// @param what  that takes the memory, with its verb: "the factor of 3 unknowns takes"
/// @throws ArgumentError if this process cannot have so many bytes more than it has now (memory_left())
void require_memory(const char* where, const std::string& what, double bytes);

} // namespace burnish
