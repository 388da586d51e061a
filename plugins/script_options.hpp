#pragma once
// The options of the script that runs.
#include "script/options.hpp"

namespace burnish {

ScriptOptions& script_options();
/// At the end of a script: prints an option of the command line that it never read, which rcOptionsEnd would have refused before.
/// @returns whether there is one
bool ignores_option();

} // namespace burnish
