#pragma once
// Error that the length of a step makes in the plastic strain, estimated by one more return (ALGORITHMS.md 2.1).
#include "workpiece/workpiece.hpp"

namespace burnish {

/// What the accepted steps of a run have shown. Plain data.
struct StepErrorState {
  double last = 0;     ///< eta of the last step, ALGORITHMS.md (2.5) [-]; 0: nothing flowed, or not estimated
  double weighted = 0; ///< sum of eta times `strain` over the steps
  double strain = 0;   ///< sum over the steps of the volume integral of the increment of plastic_strain_eq
  /// Relative error of the plastic strain increments: the constant of ALGORITHMS.md (2.6) times the mean of eta [-]; < 0: not
  /// estimated, since nothing flowed or the law gives no estimate.
  double estimate() const { return strain > 0 ? STEP_ERROR_PER_ETA * weighted / strain : -1; }
  static constexpr double STEP_ERROR_PER_ETA = 4;
};

/// Adds the step of the last update, before it is accepted. Nothing is added for laws without plastic_strain_eq, forward Euler, and
/// user-defined laws that are not the material's own by a single return.
template <int Dim> void add_step_error(const Workpiece<Dim>& workpiece, StepErrorState& state);

} // namespace burnish
