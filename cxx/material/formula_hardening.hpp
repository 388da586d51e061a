#pragma once
// Isotropic hardening by a user's formula in ep.
#include "material/hardening.hpp"

namespace burnish {

/// Where a power of ep as in A + B ep^n, n < 1, begins, whose slope at ep = 0 is not finite, the law is its chord to here.
inline constexpr double STEEP_START = 1e-5;

/// sigma_y(ep) by a formula in the variable ep, its slope differentiated exactly. Where the formula has no finite
/// value > 0, or no finite slope but at ep = 0, the law's value is not finite.
/// @param text formula [stress] in ep [-]; @param softening whether it may fall, see require_admissible
/// @throws std::invalid_argument for a wrong formula (see Formula), and naming `where` see require_admissible
std::shared_ptr<const HardeningLaw> formula_hardening(const std::string& text, bool softening,
                                                      const char* where);

} // namespace burnish
