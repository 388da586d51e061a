#pragma once
// Whether the run shall end, asked where much is still to be done before its loop can ask.
#include <functional>

namespace burnish {

/// The answer of the function that was set; false without one. All ranks ask at the same places.
bool stop_asked();
/// @param answer empty: nobody asks for an end
void set_stop_asked(std::function<bool()> answer);

} // namespace burnish
