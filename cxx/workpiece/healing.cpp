#include "workpiece/healing.hpp"
#include "base/error.hpp"

namespace burnish {

template <int Dim> long heal_all(Workpiece<Dim>& body, int steps) {
  require(steps >= 1, "heal_all", "steps", steps, ">= 1");
  if (!body.state().tracks_integrity())
    fail("heal_all", "nothing to heal, expected damage to be defined before");
  long healing = 0;
  for (int p = 0; p < body.discretization().num_points(); ++p)
    if (integrity_of(body.state(), p) < 1) {
      body.change_integrity(p, 1, steps);
      ++healing;
    }
  return healing;
}

template long heal_all<2>(Workpiece<2>&, int);
template long heal_all<3>(Workpiece<3>&, int);

} // namespace burnish
