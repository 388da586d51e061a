#pragma once
// A quadratic edge where it is now: the parabola through its nodes.
#include "base/types.hpp"
#include <array>
#include <utility>

namespace burnish {

/// Start, middle, end [length]
template <int Dim> using Parabola = std::array<Vector<Dim>, 3>;

/// Place at 0 <= s <= 1.
template <int Dim> Vector<Dim> on_parabola(const Parabola<Dim>& x, double s) {
  return (1 - s) * (1 - 2 * s) * x[0] + 4 * s * (1 - s) * x[1] + s * (2 * s - 1) * x[2];
}

/// Its place nearest to p, and the squared distance [length^2].
template <int Dim>
std::pair<Vector<Dim>, double> nearest_on_parabola(const Parabola<Dim>& x, const Vector<Dim>& p) {
  constexpr int SAMPLES = 16;     // before the nearest one is refined
  constexpr int REFINEMENTS = 30; // by a third each
  double best = 0, least = (x[0] - p).squaredNorm();
  const auto look = [&](double s) {
    const double d = (on_parabola<Dim>(x, s) - p).squaredNorm();
    if (d < least) least = d, best = s;
  };
  for (int i = 1; i <= SAMPLES; ++i) look(static_cast<double>(i) / SAMPLES);
  double width = 1. / SAMPLES;
  for (int i = 0; i < REFINEMENTS; ++i, width *= 2. / 3) {
    const double middle = best;
    look(std::max(0., middle - width / 2));
    look(std::min(1., middle + width / 2));
  }
  return {on_parabola<Dim>(x, best), least};
}

} // namespace burnish
