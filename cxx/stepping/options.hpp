#pragma once
// Options and status words shared by all ways through a step. All numbers are free of units.
#include "contact/friction_tangent.hpp"
#include "contact/linearization.hpp"
#include <string>

namespace burnish {

struct StepOptions {
  double tolerance = 1e-4; ///< residual relative to the load (largest contact resultant of the run so far)
  double gap_tolerance = 1e-6; ///< penetration and slip tolerance relative to the spacing of the candidates
  double offset_tolerance = 2e-4; ///< distance of a contact node from its tool, same scale
  int max_iterations = 25;        ///< bound on iterations of one step
  int max_backtracks = 3;         ///< steps back half way per step (ALGORITHMS.md 5.6)
  int max_state_passes = 12;      ///< active-set passes on the dense block per iteration
  int max_neutral_trials = 4;     ///< looks for a neutral point per iteration (tool_support.hpp)
  int anderson_memory = 8;        ///< 0: no mixing
  double slow = 2;       ///< residual ratio from which the iterate goes back or the tangent is taken anew
  int rate_window = 4;   ///< iterations that the rate of convergence is measured over; 0: it is not
  double rate_bound = 8; ///< a new tangent is taken where that rate leaves more iterations than this
  double rate_fall =
      0.1; ///< without elastic moduli if the last one has brought the residual down to this part
  double window_width =
      0.75; ///< candidates kept on the dense block: contact width times this beyond both ends ...
  double window_nodes = 6;   ///< ... plus this many node spacings
  double window_cover = 0.3; ///< part of that margin that must be left, else the window is chosen anew
  double state_force = 0.1;  ///< tolerance of forces in the state tests over that of the residual
  double state_gap = 0.5;    ///< tolerance of gaps there over gap_tolerance
  double state_slip = 0.1;   ///< tolerance of backward slips there over that of gaps
  double least_load = 1e-9;  ///< a load below this part of what rounding leaves is none
  double least_tool_load =
      1e-7;             ///< a tool with less than this part of the load has the tolerance of the load
  double jump_rate = 5; ///< a coordinate under force that moves so many times faster than before jumps ...
  double jump_length = 0.2;      ///< ... if its tool's points move by more than this many spacings
  double spacing_of_tool = 1e-2; ///< spacing of a single candidate, over the length scale of the first tool
  int max_indefinite = 3;        ///< tangents in a row that may be indefinite
  /// Part of elastic moduli in the tangent after 0, 1, 2, ... factorizations of the step: ends cycles of plastic points
  std::array<double, 4> blend_by_factorization{0, 0.2, 0.2, 0.4};
  /// The same after 0, 1, 2, ... losses of definiteness in a row (ALGORITHMS.md 5.2)
  std::array<double, 4> blend_by_failure{0, 0.05, 0.2, 0.8};
  /// Condensed iterations that change any number of states; later ones change one, which ends cycles
  /// (ALGORITHMS.md 5.8)
  int max_together = 8;
  double condensed_slow =
      0.7;                 ///< condensed iterations: a residual that falls by less takes more elastic moduli
  int condensed_falls = 3; ///< after so many that fall by more none are taken again
  int event_steps_per_factor = 2; ///< event steps that one factor serves
  int steps_per_factor = 1;       ///< implicit steps that one factor serves at most
  bool tied = false; ///< quadratic edges: stick and slip by forces shared to the corners (METHOD.md 3.19)
  GeometricTerms terms = GeometricTerms::COMPLETE;
  FrictionTangent friction_tangent = FrictionTangent::CONSISTENT; ///< of the iteration (METHOD.md 3.21)
};

enum class StepStatus {
  CONVERGED,   ///< residual and states within tolerance
  ITERATE,     ///< call correct()
  REFACTORIZE, ///< a new tangent is wanted, then correct()
  BACKTRACKED, ///< the iterate went half way back: evaluate the internal force again
  FAILED,      ///< give the step up; reason() tells why
};

enum class Stepping {
  IMPLICIT, ///< contact states inside the iteration, last step carried along as predictor
  EVENT,    ///< contact states fixed: the step is cut at events
  RATES,    ///< the same without prediction or correction: one linear solve from the accepted state (article)
};

} // namespace burnish
