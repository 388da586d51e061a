#pragma once
// Healing of a whole body at once (METHOD.md 1.12); by events: point_damage.hpp.
#include "workpiece/workpiece.hpp"

namespace burnish {

/// Between steps: the integrity of every point below 1 grows to 1 in equal parts of `steps` full steps.
/// @returns the number of these points
/// @throws std::invalid_argument if steps < 1, no integrity is tracked, or a step is under way; nothing has changed then
template <int Dim> long heal_all(Workpiece<Dim>& body, int steps);

} // namespace burnish
