#pragma once
// The object behind the script type `stepcontrol`, for the files that register its members.
#include "base/error.hpp"
#include "checkpoint/standby.hpp"
#include "remesh/settle.hpp"
#include "run/stepper.hpp"
#include "types.hpp"

namespace burnish {

struct ControlObject {
  static constexpr const char* TYPE = "stepcontrol";
  std::unique_ptr<StepControl> control;
  StepperOptions options;
  bool checks = true;
  std::shared_ptr<ContactObject> contact; // of the run
  std::shared_ptr<MaterialObject> material;
  std::unique_ptr<StepLoop> stepper;
  std::vector<Statement> statements; // of the accepted steps up to the last one read
  long statements_at = -1;           // how many steps those are
  Eigen::VectorXd u;                 // as the last task left it
  Task task = Task::STOPPED;
  std::vector<Remeshing> remeshings; // of the run
  bool stopping = false;             // the script has ended the run
  bool remeshed = false;             // the run is no more on the mesh that it began on
  std::vector<IdentityPart> scene;   // what the run began with, for its checkpoints
  bool checkpointed = false;         // the run has been written to a checkpoint, or goes on from one
  StandbyCheckpoint standby;         // of a run that may be given up in the middle of a step
  bool under_way() const { return stepper && task != Task::FINISHED && task != Task::STOPPED; }
  ControlObject() = default;
  ControlObject(const ControlObject&) = delete;
  ControlObject& operator=(const ControlObject&) = delete;
  ~ControlObject() {
    if (contact) contact->under_way = false;
  }
  const StepControl& now() const { return stepper ? stepper->control() : *control; }
  StepLoop& running(const char* where) const {
    if (!stepper) fail(where, "no run has been started, call start first");
    return *stepper;
  }
};

using StepControlHandle = Handle<ControlObject>;

/// Called by register_step_control, after the type.
void register_step_data();
void register_scene_report();

/// A stepper of a run of this stepcontrol, at its start; in its place from here on.
template <int Dim>
Stepper<Dim>& begin_stepper(const std::shared_ptr<ControlObject>& control, ContactOf<Dim>& contact,
                            MaterialOf<Dim>& material);

/// The report, made when it is read for the first time after a step.
const std::vector<Statement>& statements_of(StepControlHandle* h);

} // namespace burnish
