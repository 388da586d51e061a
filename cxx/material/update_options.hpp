#pragma once
// Choices of the stress update (algorithms.md section 2).
#include "material/j2.hpp"

namespace burnish {

struct UpdateOptions {
  StressUpdate update = StressUpdate::SUBSTEPPED;
  StrainFrame strain_frame = StrainFrame::END;
  double path_limit = 1.5;                 ///< L of algorithms.md section 2; 0: straight; infinite: no limit
  int min_substeps = 3, max_substeps = 20; ///< bounds of the number of substeps of a point
  double substep_strain = 0.3;             ///< substep when q(De) exceeds this fraction of sigma_y
  int freeze_iteration = 3; ///< number of substeps may only grow before, is frozen from here on
};

/// @throws std::invalid_argument naming `where` unless path_limit >= 0 (may be infinite),
///         1 <= min_substeps <= max_substeps, substep_strain > 0, freeze_iteration >= 1
void require_valid(const UpdateOptions& options, const char* where);

} // namespace burnish
