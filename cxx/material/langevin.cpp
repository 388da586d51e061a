#include "material/langevin.hpp"
#include <cmath>

namespace burnish {

Langevin langevin(double u) {
  // its series, for u below SERIES, where the closed form loses digits
  constexpr double SERIES = 0.05;
  constexpr double COEFFICIENTS[] = {1. / 3,
                                     4. / 45,
                                     44. / 945,
                                     428. / 14175,
                                     10196. / 467775,
                                     10719068. / 638512875,
                                     25865068. / 1915538625,
                                     5472607916. / 488462349375,
                                     0.009516073194527899,
                                     0.008231206567350501};
  constexpr int TERMS = sizeof COEFFICIENTS / sizeof *COEFFICIENTS;
  if (u < SERIES) {
    Langevin k{0, 0};
    for (int n = TERMS - 1; n >= 0; --n) {
      k.slope = k.slope * u + k.value;
      k.value = k.value * u + COEFFICIENTS[n];
    }
    return k;
  }
  const double z = std::sqrt(u), x = std::atanh(z);
  const double ratio = z / x, ratio_by_z = (1 - ratio / (1 - u)) / x; // d(z/x)/dz, dx/dz = 1/(1 - z^2)
  const double value = (1 - ratio) / u;
  return {value, (-ratio_by_z / (2 * z) - value) / u};
}

} // namespace burnish
