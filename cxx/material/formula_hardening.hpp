#pragma once
// Isotropic hardening by a user's formula in ep.
#include "material/hardening.hpp"

namespace burnish {

/// sigma_y(ep) by a formula in the variable ep, its slope differentiated exactly. Where the formula has no finite
/// value > 0, or no finite slope, the law's value is not finite.
/// @param text formula [stress] in ep [-]; @param softening whether it may fall, see require_admissible
/// @throws std::invalid_argument for a wrong formula (see Formula), and naming `where` see require_admissible
std::shared_ptr<const HardeningLaw> formula_hardening(const std::string& text, bool softening,
                                                      const char* where);

} // namespace burnish
