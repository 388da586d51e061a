#include "material/j2/trapezoidal_return.hpp"
#include <limits>

namespace burnish {
namespace {

// METHOD.md (1.34) with a straight line through sigma_y and its slope at ep
double on_tangent(const YieldStress& yield, double q2, double c, double g) {
  const double H = yield.slope, Y = yield.value;
  const double A = H * (H + 2 * g), B = Y * (H + g) + g * c, C = q2 - Y * Y;
  return C / (B + std::sqrt(B * B + A * C));
}

} // namespace

// The left side falls from > 0 at 0 to < 0 at q2/(2 g c).
double trapezoidal_increment(const HardeningLaw& hardening, const YieldStress& yield,
                             double plastic_strain_eq, double q2, double c, double g) {
  if (hardening.is_linear()) return on_tangent(yield, q2, c, g);
  constexpr double NONE = std::numeric_limits<double>::quiet_NaN();
  constexpr int MAX_PASSES = 100;          // bisection alone would need some 50
  constexpr double RELATIVE_ERROR = 1e-15; // of q2: rounding
  double low = 0, high = q2 / (2 * g * c), x = on_tangent(yield, q2, c, g);
  for (int k = 0; k < MAX_PASSES; ++k) {
    if (!(x > low && x < high)) x = 0.5 * (low + high);
    const auto [Y, H] = hardening.at(plastic_strain_eq + x);
    if (!(2 * g + H > 0)) return NONE;
    const double excess = q2 - 2 * g * x * (c + Y) - Y * Y;
    if (!std::isfinite(excess)) return NONE;
    if (std::abs(excess) <= RELATIVE_ERROR * q2) break;
    (excess > 0 ? low : high) = x;
    const double next = x + excess / (2 * (g * (c + Y) + (Y + g * x) * H));
    if (next == x) break;
    x = next;
  }
  return x;
}

} // namespace burnish
