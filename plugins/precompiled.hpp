// Read once for all sources of the plugin, by make only (flag -include): every file includes what it needs itself.
#include "base/precompiled.hpp"

#include "ff++.hpp"

#include "AFunction_ext.hpp" // after ff++.hpp
