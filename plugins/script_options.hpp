#pragma once
// The options of the script that runs.
#include "script/options.hpp"

namespace burnish {

ScriptOptions& script_options();

} // namespace burnish
