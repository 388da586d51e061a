#pragma once
// Forces that are no load: what is left of a tool under zero force (ALGORITHMS.md 16.1).
#include "diagnosis/accepted_step.hpp"

namespace burnish {

/// Whether a load is zero, or its tolerance below a billionth of what rounding leaves, ALGORITHMS.md (5.1): nothing is judged over it.
/// @param load >= 0 [force]
template <int Dim> bool is_no_load(const AcceptedStep<Dim>& step, double load) {
  constexpr double least = 1e-9; // the iteration allows so much of rounding in any case
  return !(load > 0) || step.allowed.relative * load < least * step.allowed.rounding;
}

} // namespace burnish
