#pragma once
// A run that starts from the end of another one: the same workpiece, with other tools, supports, labels and steps.
#include "workpiece/initial_values.hpp"
#include <string>

namespace burnish {

/// Where a stage starts.
struct StageStart {
  double t = 0;              ///< of the state in the run that it is from [time]
  bool same_material = true; ///< it is described by the same words
  OutOfBalance balance;
};

/// Puts displacement, stress, internal variables and integrities of a checkpoint in place of the workpiece's, as they are.
/// @param fixed Dim*num_nodes flags: supports of the stage
/// @throws std::invalid_argument as read_checkpoint; if the mesh is another one than that of the run's end (one that the run has gone
///         over to may be rounded to twelve digits), or the law keeps other internal variables
template <int Dim>
StageStart start_stage(const std::string& path, const std::vector<char>& fixed, Workpiece<Dim>& workpiece);

} // namespace burnish
