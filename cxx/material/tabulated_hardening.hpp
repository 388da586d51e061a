#pragma once
// Isotropic hardening by a table of plastic strains and yield stresses.
#include "material/hardening.hpp"

namespace burnish {

/// sigma_y(ep) straight between the entries, constant beyond the last one; its slope at an entry is that behind it.
/// @param plastic_strain ep of the entries, the first 0, each larger than the one before [-]
/// @param yield_stress sigma_y there, > 0 [stress]; @param softening whether it may fall
/// @throws std::invalid_argument "where: ..." naming entry and value: sizes differ, no entries, ep not finite, not
///         starting at 0 or not increasing, a yield stress that is not finite > 0, or that falls without softening
std::shared_ptr<const HardeningLaw> tabulated_hardening(const std::vector<double>& plastic_strain,
                                                        const std::vector<double>& yield_stress,
                                                        bool softening, const char* where);

} // namespace burnish
