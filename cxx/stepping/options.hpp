#pragma once
// Options and status words shared by both ways through a step. All numbers are free of units.
#include "contact/linearization.hpp"
#include <string>

namespace burnish {

struct StepOptions {
  double tolerance = 1e-4; ///< residual relative to the load (largest contact resultant of the run so far)
  double gap_tolerance = 1e-6; ///< penetration and slip tolerance relative to the spacing of the candidates
  double offset_tolerance = 2e-4; ///< distance of a contact node from its tool, same scale
  int max_iterations = 25;        ///< bound on iterations of one step
  int max_backtracks = 3;         ///< steps back half way per step (algorithms.md 5.6)
  int max_state_passes = 12;      ///< active-set passes on the dense block per iteration
  int anderson_memory = 8;        ///< 0: no mixing
  double slow = 2; ///< residual ratio from which the iterate goes back or the tangent is taken anew
  double window_width =
      0.75; ///< candidates kept on the dense block: contact width times this beyond both ends ...
  double window_nodes = 6; ///< ... plus this many node spacings
  GeometricTerms terms = GeometricTerms::COMPLETE;
};

enum class StepStatus {
  CONVERGED,   ///< residual and states within tolerance
  ITERATE,     ///< call correct()
  REFACTORIZE, ///< a new tangent is wanted, then correct()
  BACKTRACKED, ///< the iterate went half way back: evaluate the internal force again
  FAILED,      ///< give the step up; reason() tells why
};

} // namespace burnish
