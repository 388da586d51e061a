#pragma once
// Numbers that are spread evenly, for samples of surfaces.
#include <cmath>

namespace burnish {

/// Part i of a sequence in [0, 1) of which every beginning is spread evenly: multiples of the golden ratio.
inline double spread(int i) {
  const double golden = (std::sqrt(5.) - 1) / 2;
  return i * golden - std::floor(i * golden);
}

} // namespace burnish
