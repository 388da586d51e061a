#pragma once
// Does a chain of CAD curves cross itself?
#include "cad/occ/cad_search.hpp"

namespace burnish {

/// Cells whose chords come closer than their sags are halved until they part, or are closer than about 1e-9
/// of their length. Cells between which the chain turns by less than 180 degrees cannot meet.
/// @throws std::invalid_argument, with place and tags, if the chain crosses or touches itself
void check_crossings(const CadChain& chain, const std::vector<CadCell>& cells);

} // namespace burnish
