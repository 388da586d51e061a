#include "run_checkpoint.hpp"
#include "base/error.hpp"
#include "checkpoint.hpp"
#include "checkpoint/identity.hpp"
#include "remesh.hpp"
#include "remesh/stored_mesh.hpp"
#include "run/run_archive.hpp"
#include "script_options.hpp"
#include <cstdlib>

namespace burnish {

const std::vector<IdentityPart>& script_identity() {
  static const std::vector<IdentityPart> parts = [] {
    const char* path = std::getenv("FF_INCLUDEPATH");
    return identity_of(script_options(), path ? path : "");
  }();
  return parts;
}

namespace {

std::vector<IdentityPart> identity_of_run(const ControlObject& object) {
  std::vector<IdentityPart> parts = object.scene;
  parts.insert(parts.end(), script_identity().begin(), script_identity().end());
  return parts;
}

template <int Dim> Stepper<Dim>& stepper_of(ControlObject& object) {
  return static_cast<Stepper<Dim>&>(*object.stepper);
}

RunMesh run_mesh(const MaterialOf<2>& material) { return {material.mesh.get(), nullptr}; }
RunMesh run_mesh(const MaterialOf<3>& material) { return {nullptr, material.mesh.get()}; }

// A mesh that the run has gone over to.
template <int Dim>
void keep_mesh(const ControlObject& object, ContactOf<Dim>& contact, Checkpoint& checkpoint) {
  if (!object.remeshed) return;
  const ContactSetup<Dim>& setup = *contact.setup;
  checkpoint.mesh = packed(StoredMesh<Dim>{setup.mesh(), setup.body().fixed, object.remeshings});
  checkpoint.script_mesh = mesh_bytes(*of_dimension<Dim>(*object.material, "stepcontrol.checkpoint").mesh);
}

// The run that the script has begun goes over to the mesh of the checkpoint.
template <int Dim>
void take_kept_mesh(const std::shared_ptr<ControlObject>& object, ContactOf<Dim>& contact,
                    const Checkpoint& checkpoint) {
  if (checkpoint.mesh.empty()) return;
  auto& material = of_dimension<Dim>(*object->material, "stepcontrol.resume");
  StoredMesh<Dim> kept = unpacked_mesh<Dim>(checkpoint.mesh);
  using FreefemMesh = const typename Freefem<Dim>::Mesh;
  const std::shared_ptr<FreefemMesh> mesh(mesh_of_bytes<typename Freefem<Dim>::Mesh>(checkpoint.script_mesh),
                                          [](FreefemMesh* shared) { shared->destroy(); });
  take_mesh<Dim>(contact, material, on_stored_mesh(material.workpiece(), contact.run(), kept), mesh);
  begin_stepper<Dim>(object, contact, material);
  object->remeshed = true;
  object->remeshings = std::move(kept.remeshings);
}

} // namespace

Checkpoint checkpoint_of(ControlObject& object, const std::string& folder, Stack stack,
                         const ScriptValues& script) {
  constexpr const char* WHERE = "stepcontrol.checkpoint";
  const StepLoop& loop = object.running(WHERE);
  if (object.task != Task::RECORD && object.task != Task::FINISHED)
    fail(WHERE, "a run in the middle of a step, expected one that has just recorded a step");
  Checkpoint checkpoint;
  checkpoint.t = loop.control().time();
  checkpoint.t_end = loop.control().options().t_end;
  checkpoint.identity = identity_of_run(object);
  visit(*object.contact, [&](auto& contact) {
    constexpr int Dim = dim_of<decltype(contact)>;
    auto& material = of_dimension<Dim>(*object.material, WHERE);
    checkpoint.values = script.changed(stack, run_mesh(material));
    keep_mesh<Dim>(object, contact, checkpoint);
    checkpoint.state = packed(stepper_of<Dim>(object).state());
    checkpoint.solver = contact.solver;
  });
  const std::vector<std::string> files(growing_paths().begin(), growing_paths().end());
  checkpoint.files = growing_files(files, folder);
  return checkpoint;
}

void RunArrays::take(const Eigen::VectorXd& displacement, const Eigen::VectorXd& force, Stack stack) const {
  to_array(displacement, GetAny<KN_<double>>((*u)(stack)), "stepcontrol.resume");
  to_array(force, GetAny<KN_<double>>((*R)(stack)), "stepcontrol.resume");
}

void take_checkpoint(const std::shared_ptr<ControlObject>& shared, const CheckpointPlace& from,
                     const Checkpoint& checkpoint, const RunArrays& arrays, Stack stack,
                     const ScriptValues& script) {
  constexpr const char* WHERE = "stepcontrol.resume";
  ControlObject& object = *shared;
  object.running(WHERE);
  require_same(from.file, checkpoint.identity, identity_of_run(object));
  visit(*object.contact, [&](auto& contact) {
    constexpr int Dim = dim_of<decltype(contact)>;
    take_kept_mesh<Dim>(shared, contact, checkpoint);
    contact.take_solver(checkpoint.solver, stack, WHERE);
    const RunState<Dim> state = unpacked<Dim>(checkpoint.state);
    Eigen::VectorXd v, force;
    stepper_of<Dim>(object).set_state(state, v, force);
    const bool cut = !(from.later && object.stepper->control().finished());
    for (const std::string& file :
         cut ? cut_files(checkpoint.files, from.folder) : present_paths(checkpoint.files, from.folder))
      growing_paths().insert(file);
    script.restore(stack, checkpoint.values, run_mesh(of_dimension<Dim>(*object.material, WHERE)));
    arrays.take(v, force, stack);
    object.u = std::move(v);
  });
  *object.control = object.stepper->control();
  object.statements_at = -1;
}

} // namespace burnish
