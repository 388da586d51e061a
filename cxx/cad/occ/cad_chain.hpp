#pragma once
// CAD curves in the order in which they join.
#include "cad/occ/cad_piece.hpp"

namespace burnish {

struct CadChain {
  std::vector<CadPiece> pieces; ///< in the order of travel, each in its direction
  bool closed;
};

/// Orders and turns the curves so that each begins where the one before ends (to 1e-6 of the size of the
/// whole). The first curve given keeps its direction; a closed chain begins with it.
/// @throws std::invalid_argument, with place and tags: curves that do not join into one chain, branching, a
/// corner (tangents of neighbors differ by more than 1e-3 rad), a curve without tangent at its end
CadChain chained(const std::vector<CadPiece>& curves);

} // namespace burnish
