#pragma once
// The settings of a run as named parameters of a constructor, and as options of the command line.
#include "named.hpp"
#include "run/settings.hpp"

namespace burnish {

/// The entries of names[] for the settings of rcContact, stepcontrol or rcMaterial, with `more` ones after them.
std::vector<basicAC_F0::name_and_type> setting_names(const std::string& owner,
                                                     const std::vector<basicAC_F0::name_and_type>& more);

/// The settings of the owner: the defaults, over them what the call gave, over them -name of the command line, unless the
/// script has read that option itself. @param where of errors
/// @throws std::invalid_argument for a value outside of its range
Settings settings_of(const Named& named, const std::string& owner, const char* where);

/// Lets rcOptionsEnd take -name of every setting whose owner the script uses.
void accept_settings();

} // namespace burnish
