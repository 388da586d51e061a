#pragma once

namespace burnish {

/// k(u) = (coth x - 1/x)/tanh x with tanh^2 x = u, and dk/du: even in x, so smooth in u = 0..1.
struct Langevin {
  double value, slope;
};
Langevin langevin(double u);

} // namespace burnish
