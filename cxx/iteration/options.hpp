#pragma once
// Options and status words shared by all ways through a step. All numbers are free of units.
#include "contact/friction_tangent.hpp"
#include "contact/linearization.hpp"
#include <string>

namespace burnish {

struct IterationOptions {
  double tolerance = 1e-4; ///< residual relative to the load (largest contact resultant of the run so far)
  double gap_tolerance = 1e-6; ///< penetration and slip tolerance relative to the spacing of the candidates
  double offset_tolerance = 2e-4; ///< distance of a contact node from its tool, same scale
  int max_iterations = 25;        ///< bound on iterations of one step
  int anderson_memory = 8;        ///< 0: no mixing
  int steps_per_factor = 1;       ///< implicit steps that one factor serves at most
  bool tied = false; ///< quadratic edges: stick and slip by forces shared to the corners (METHOD.md 3.19)
  GeometricTerms terms = GeometricTerms::COMPLETE;
  FrictionTangent friction_tangent = FrictionTangent::CONSISTENT; ///< of the iteration (METHOD.md 3.21)
};

enum class StepStatus {
  CONVERGED,   ///< residual and states within tolerance
  ITERATE,     ///< call correct()
  REFACTORIZE, ///< a new tangent is wanted, then correct()
  BACKTRACKED, ///< the iterate went part of the way back: evaluate the internal force again
  FAILED,      ///< give the step up; reason() tells why
};

enum class Stepping {
  IMPLICIT, ///< contact states inside the iteration, last step carried along as predictor
  EVENT,    ///< contact states fixed: the step is cut at events
  RATES,    ///< the same without prediction or correction: one linear solve from the accepted state (article)
};

} // namespace burnish
