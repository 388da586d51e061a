#pragma once
// Choices of the stress update (ALGORITHMS.md 2).

namespace burnish {

enum class StressUpdate {
  SUBSTEPPED,    ///< sub-stepped radial return on the quadratic strain path (ALGORITHMS.md 2)
  SINGLE,        ///< one radial return per step
  FORWARD_EULER, ///< the article's: METHOD.md (1.6) times the increment, no return, leaves the surface
};
/// Frame in which the strain increments meet the turned old stress.
enum class StrainFrame {
  MIDPOINT, ///< dd and dd_p as they are: first order where the body spins
  END,      ///< dd turned by half the rotation, METHOD.md (1.14), dd_p by the whole: second order
};

constexpr double SUBSTEP_STRAIN = 0.3; ///< q of the elastic increment of a substep over sigma_y, at most
constexpr int FREEZE_ITERATION = 3;    ///< number of substeps may only grow before, is frozen from here on

/// Each law takes the ones that concern it.
struct UpdateOptions {
  StressUpdate update = StressUpdate::SUBSTEPPED;
  StrainFrame strain_frame = StrainFrame::END;
  double path_limit = 1.5;                 ///< L of ALGORITHMS.md (2.2); 0: straight; infinite: no limit
  int min_substeps = 3, max_substeps = 20; ///< bounds of the number of substeps of a point
};

/// @throws std::invalid_argument naming `where` unless path_limit >= 0 (may be infinite),
///         1 <= min_substeps <= max_substeps
void require_valid(const UpdateOptions& options, const char* where);

} // namespace burnish
