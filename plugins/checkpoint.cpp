// Checkpoints: a run goes on from one to the same bits, in another process. rcRun writes and reads them by itself
// (edp/run/rcCheckpoint.idp); a loop of the script's own calls these.
//   S.checkpoint(file)   writes state, variables and sizes of files of the run, in record or after the end; the file that was there
//       becomes FILE.old
//     file      path
//     ! expected one that has just recorded a step
//   S.resume(file, u, R)   after start: goes on from it, with the script's variables as they were; files to which lines were added are cut
//       to what they were. Option -resume 2: from FILE.old
//     file      path
//     u         displacement of the run, out | length
//     R         nodal forces, out | force
//     ! is of another run
//     ! is cut off
//     ! is damaged
//     ! is no checkpoint of Burnish
//   S.checkpointdue   the time of option -checkpoint is over since the last one, Ctrl-C came (in the middle of a step: less than
//       five seconds ago), or the run is at its end and has had one
//   internal: rcResumeOption rcResumable rcNoteVariables rcOutdated rcRunFile
#include "checkpoint.hpp"
#include "base/error.hpp"
#include "base/stop_request.hpp"
#include "checkpoint/identity.hpp"
#include "named.hpp"
#include "parallel/first_rank.hpp"
#include "remesh.hpp"
#include "remesh/stored_mesh.hpp"
#include "run/run_archive.hpp"
#include "script/words.hpp"
#include "script_options.hpp"
#include "script_values.hpp"
#include "step_control.hpp"
#include <chrono>
#include <cstdlib>
#include <filesystem>

namespace burnish {

namespace fs = std::filesystem;

std::set<std::string>& growing_paths() {
  static std::set<std::string> paths;
  return paths;
}

// As edp/cases/rcCaseOptions.idp says.
constexpr const char
    *CHECKPOINT_MEANS = "between two checkpoints of a run; 0: none",
    *RESUME_MEANS = "1: goes on from the last checkpoint of a run that was killed, 2: from the one before";

long resume_option() {
  const long which = script_options().integer("-resume", 0, "-", RESUME_MEANS);
  require(which >= 0 && which <= 2, "option", "-resume", which, "0, 1 or 2");
  return which;
}

namespace {

// Words of a script that has runs.
constexpr const char* RUNS = "rcRun rcRunForms rcRunLaw rcCondensedRun rcCondensedRunLaw rcCase rcCaseForms "
                             "rcCaseLaw checkpoint resume";
using RunClock = std::chrono::steady_clock; // goes on where the wall clock is put back

// Of the last checkpoint; at first of the start.
RunClock::time_point& last_written() {
  static RunClock::time_point at = RunClock::now();
  return at;
}

double minutes_option() {
  const double minutes = script_options().real("-checkpoint", 10, "min", CHECKPOINT_MEANS);
  require(minutes >= 0, "option", "-checkpoint", minutes, ">= 0");
  return minutes;
}

// The script's part, as it was when it began.
const std::vector<IdentityPart>& script_identity() {
  static const std::vector<IdentityPart> parts = [] {
    const char* path = std::getenv("FF_INCLUDEPATH");
    return identity_of(script_options(), path ? path : "");
  }();
  return parts;
}

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

void write_run(ControlObject& object, const std::string& path, Stack stack, const ScriptValues& script) {
  constexpr const char* WHERE = "stepcontrol.checkpoint";
  const StepLoop& loop = object.running(WHERE);
  if (object.task != Task::RECORD && object.task != Task::FINISHED)
    fail(WHERE, "a run in the middle of a step, expected one that has just recorded a step");
  last_written() = RunClock::now();
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
  const std::string folder = fs::path(path).parent_path().string();
  std::error_code unmade; // is told when the file is written
  if (!folder.empty()) fs::create_directories(folder, unmade);
  const std::vector<std::string> files(growing_paths().begin(), growing_paths().end());
  checkpoint.files = growing_files(files, folder.empty() ? "." : folder);
  on_first_rank([&] { write_checkpoint(path, checkpoint); });
  object.checkpointed = true;
  last_written() = RunClock::now();
}

/// Arrays of a script; asked for when its variables are as they were, for they may be on another mesh then.
struct RunArrays {
  Expression u, R;
  void take(const Eigen::VectorXd& displacement, const Eigen::VectorXd& force, Stack stack) const {
    to_array(displacement, GetAny<KN_<double>>((*u)(stack)), "stepcontrol.resume");
    to_array(force, GetAny<KN_<double>>((*R)(stack)), "stepcontrol.resume");
  }
};

void resume_run(const std::shared_ptr<ControlObject>& shared, const std::string& path,
                const RunArrays& arrays, Stack stack, const ScriptValues& script) {
  constexpr const char* WHERE = "stepcontrol.resume";
  ControlObject& object = *shared;
  object.running(WHERE);
  const std::string from = resume_option() == 2 ? path + OLDER : path;
  const Checkpoint checkpoint = read_checkpoint(from);
  require_same(from, checkpoint.identity, identity_of_run(object));
  visit(*object.contact, [&](auto& contact) {
    constexpr int Dim = dim_of<decltype(contact)>;
    take_kept_mesh<Dim>(shared, contact, checkpoint);
    contact.take_solver(checkpoint.solver, stack, WHERE);
    const RunState<Dim> state = unpacked<Dim>(checkpoint.state);
    Eigen::VectorXd v, force;
    stepper_of<Dim>(object).set_state(state, v, force);
    const std::string folder = fs::path(path).parent_path().string();
    for (const std::string& file : cut_files(checkpoint.files, folder.empty() ? "." : folder))
      growing_paths().insert(file);
    script.restore(stack, checkpoint.values, run_mesh(of_dimension<Dim>(*object.material, WHERE)));
    arrays.take(v, force, stack);
    object.u = std::move(v);
  });
  *object.control = object.stepper->control();
  object.statements_at = -1;
  object.checkpointed = true;
  last_written() = RunClock::now();
  first_rank_says(true); // all have read it
  cout << "burnish: goes on from " << from << ", t = " << checkpoint.t << " of " << checkpoint.t_end << endl;
}

struct CheckpointTag {};
struct ResumeTag {};
using Checkpointing = Method<StepControlHandle, CheckpointTag>;
using Resuming = Method<StepControlHandle, ResumeTag>;

/// A function of the script that is compiled where it is called, and sees the variables there.
using Expressions = std::vector<Expression>;
using Work = void (*)(const Expressions&, Stack, const ScriptValues&);
template <Work work, class... Types> class SeesVariables : public OneOperator {
public:
  SeesVariables() : OneOperator(atype<bool>(), atype<Types>()...) {}
  E_F0* code(const basicAC_F0& args) const override {
    Expressions given;
    for (int i = 0; i < args.size(); ++i) given.push_back(t[i]->CastTo(args[i]));
    return new Call(std::move(given));
  }

private:
  struct Call : E_F0mps {
    explicit Call(Expressions given) : m_given(std::move(given)) {}
    AnyType operator()(Stack stack) const override {
      guarded([&] { work(m_given, stack, m_values); });
      return SetAny<bool>(true);
    }
    Expressions m_given;
    ScriptValues m_values;
  };
};

template <class T> T value_of(Expression argument, Stack stack) { return GetAny<T>((*argument)(stack)); }
void checkpoint_here(const Expressions& given, Stack stack, const ScriptValues& values) {
  const auto object = value_of<Checkpointing>(given[0], stack);
  write_run(object->get(), *value_of<string*>(given[1], stack), stack, values);
}
void resume_here(const Expressions& given, Stack stack, const ScriptValues& values) {
  const auto object = value_of<Resuming>(given[0], stack);
  resume_run(object->share(), *value_of<string*>(given[1], stack), {given[2], given[3]}, stack, values);
}
void note_here(const Expressions&, Stack stack, const ScriptValues& values) { values.note(stack); }

bool checkpoint_due(StepControlHandle* const& h) {
  return guarded([&] {
    const ControlObject& object = h->get();
    const double minutes = minutes_option();
    if (minutes == 0) return false;
    if (interrupt_came()) return object.task == Task::RECORD || !interrupt_is_old();
    if (object.checkpointed && object.now().finished()) return true;
    const std::chrono::duration<double, std::ratio<60>> since = RunClock::now() - last_written();
    return first_rank_says(since.count() >= minutes);
  });
}
long resume_asked(const long&) {
  return guarded([] { return resume_option(); });
}
bool resumable(string* const& path) {
  return guarded([&] {
    std::error_code code;
    const bool there = fs::exists(*path, code) || fs::exists(*path + OLDER, code);
    return first_rank_says(resume_option() > 0 && there);
  });
}
// A run begins anew: the checkpoint of an earlier one counts as the one before the next.
bool outdated(string* const& path) {
  on_first_rank([&] {
    std::error_code code;
    if (fs::exists(*path, code)) fs::rename(*path, *path + OLDER, code);
  });
  script_identity();
  return true;
}

// "" : a script without a folder of results
string* run_file(Stack stack, string* const& folder, const long& number) {
  const fs::path in =
      folder->empty() ? "out" / fs::path(script_options().script()).stem() : fs::path(*folder);
  return new_string(stack, (in / ("run-" + std::to_string(number) + ".checkpoint")).string());
}

} // namespace

void accept_checkpoint_options() {
  const char* path = std::getenv("FF_INCLUDEPATH");
  if (!script_uses(script_options().script(), RUNS, path ? path : "")) return;
  for (const char* name : {"-checkpoint", "-resume"}) script_options().accept(name);
}

// In the middle of a step: without a checkpoint at once, else when the step has taken too long to wait for its end.
bool run_shall_stop() {
  return run_catches_interrupt() && interrupt_came() && (minutes_option() == 0 || interrupt_is_old());
}

void register_checkpoint() {
  last_written();
  set_stop_asked(run_shall_stop);
  add_method<StepControlHandle, CheckpointTag>(
      "checkpoint", [] { return new SeesVariables<checkpoint_here, Checkpointing, string*>; });
  add_method<StepControlHandle, ResumeTag>(
      "resume", [] { return new SeesVariables<resume_here, Resuming, string*, KN_<double>, KN_<double>>; });
  Add<StepControlHandle*>("checkpointdue", ".", new OneOperator1_<bool, StepControlHandle*>(checkpoint_due));
  Global.Add("rcNoteVariables", "(", new SeesVariables<note_here, long>);
  Global.Add("rcResumeOption", "(", new OneOperator1_<long, long>(resume_asked));
  Global.Add("rcResumable", "(", new OneOperator1_<bool, string*>(resumable));
  Global.Add("rcRunFile", "(", new OneOperator2s_<string*, string*, long>(run_file));
  Global.Add("rcOutdated", "(", new OneOperator1_<bool, string*>(outdated));
}

} // namespace burnish
