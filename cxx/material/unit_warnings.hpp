#pragma once
// Numbers of a material that no known one has: units mixed.
#include "material/law_parameter.hpp"
#include <string>
#include <vector>

namespace burnish {

/// @param numbers G or E with nu, sigY, H as far as they are given [stress]
/// @returns one line for each ratio outside the range of known materials, "" if there is none: sigY/E from 1e-6 (annealed
///          single crystals have 1e-5), H/E up to 1. A yield stress above E is that of an elastic body on purpose if it is at least 1e30,
///          a power of ten, or a power of ten up to 1e6 times E or G; else a slip
/// @param plastic_strain table of the yield stress, empty: none; one that ends above 8 is taken for per cent [-]
std::string unit_warnings(const LawNumbers& numbers, const char* where,
                          const std::vector<double>& plastic_strain = {});

} // namespace burnish
