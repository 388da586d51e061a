#pragma once
// The checkpoint of a run, of the objects of its script, and back.
#include "checkpoint/checkpoint.hpp"
#include "plugin.hpp"
#include "script_values.hpp"
#include "step_control.hpp"

namespace burnish {

/// The script's part of what a run belongs to, as it was when this was first asked for.
const std::vector<IdentityPart>& script_identity();

/// @param folder of the file that it is for @param script the variables where it is called
/// @throws std::invalid_argument unless the run has just recorded a step, or is at its end
Checkpoint checkpoint_of(ControlObject& object, const std::string& folder, Stack stack,
                         const ScriptValues& script);

/// Arrays of a script; asked for when its variables are as they were, for they may be on another mesh then.
struct RunArrays {
  Expression u, R;
  void take(const Eigen::VectorXd& displacement, const Eigen::VectorXd& force, Stack stack) const;
};
/// Where a checkpoint was read, and the folder that its files are in.
struct CheckpointPlace {
  std::string file, folder;
  bool later; ///< a later run of the script has one: if this run is at its end, files are left to that
};

/// A run that has just begun goes on from there, with the variables of the script and the files as they were.
/// @throws std::invalid_argument naming what differs
void take_checkpoint(const std::shared_ptr<ControlObject>& shared, const CheckpointPlace& from,
                     const Checkpoint& checkpoint, const RunArrays& arrays, Stack stack,
                     const ScriptValues& script);

} // namespace burnish
