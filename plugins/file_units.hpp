#pragma once
// The units that the script has said, rcUnits.
#include "output/file_units.hpp"

namespace burnish {

FileUnits& units_of_files();

} // namespace burnish
