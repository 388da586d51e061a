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
//   internal: rcEndOnly rcStandBy rcStandbyWrite rcResumeOption rcResumable rcNoteVariables rcOutdated rcRunFile
#include "checkpoint.hpp"
#include "base/error.hpp"
#include "base/stop_request.hpp"
#include "checkpoint/run_files.hpp"
#include "named.hpp"
#include "parallel/first_rank.hpp"
#include "run_checkpoint.hpp"
#include "script/words.hpp"
#include "script_options.hpp"
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

double run_clock() { return std::chrono::duration<double>(RunClock::now().time_since_epoch()).count(); }
std::string folder_of_file(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

void to_disk(ControlObject& object, const std::string& path, const Checkpoint& checkpoint) {
  std::error_code unmade; // is told when the file is written
  fs::create_directories(folder_of_file(path), unmade);
  on_first_rank([&] { write_checkpoint(path, checkpoint); });
  object.checkpointed = true;
  last_written() = RunClock::now();
}

void write_run(ControlObject& object, const std::string& path, Stack stack, const ScriptValues& script) {
  last_written() = RunClock::now();
  object.standby.clear();
  to_disk(object, path, checkpoint_of(object, folder_of_file(path), stack, script));
}

// In memory, for a step that will be given up; without one where memory is short.
void stand_by(ControlObject& object, const std::string& path, Stack stack, const ScriptValues& script) {
  const double begun = run_clock();
  if (minutes_option() == 0 || !first_rank_says(object.standby.due(begun))) return;
  object.standby.clear();
  try {
    Checkpoint checkpoint = checkpoint_of(object, folder_of_file(path), stack, script);
    const double now = run_clock();
    object.standby.keep(std::move(checkpoint), now, now - begun);
  } catch (const std::bad_alloc&) {
  }
}

// "": none
string* write_standby(Stack stack, StepControlHandle* const& control, string* const& path) {
  return guarded([&] {
    ControlObject& object = control->get();
    const Checkpoint* const checkpoint = object.standby.get();
    if (!checkpoint) return new_string(stack, "");
    to_disk(object, *path, *checkpoint);
    std::ostringstream said;
    said << checkpoint->t;
    object.standby.clear();
    return new_string(stack, said.str());
  });
}

bool later_run(const std::string& path) { return first_rank_says(!later_run_files(path).empty()); }

void resume_run(const std::shared_ptr<ControlObject>& object, const std::string& path,
                const RunArrays& arrays, Stack stack, const ScriptValues& script) {
  const bool later = later_run(path);
  const std::string from = resume_option() == 2 && !later ? path + OLDER : path;
  const Checkpoint checkpoint = read_checkpoint(from);
  take_checkpoint(object, {from, folder_of_file(path), later}, checkpoint, arrays, stack, script);
  object->checkpointed = true;
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
void stand_by_here(const Expressions& given, Stack stack, const ScriptValues& values) {
  stand_by(value_of<StepControlHandle*>(given[0], stack)->get(), *value_of<string*>(given[1], stack), stack,
           values);
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
  const bool over = resume_option() == 0; // the whole script
  on_first_rank([&] {
    std::error_code code;
    if (over)
      for (const std::string& later : later_run_files(*path)) fs::remove(later, code);
    if (fs::exists(*path, code)) fs::rename(*path, *path + OLDER, code);
  });
  script_identity();
  return true;
}

// Of a run that has been resumed: a later one goes on, with the files as they are.
bool read_for_its_end(StepControlHandle* const& control, string* const& path) {
  return guarded([&] { return control->get().now().finished() && later_run(*path); });
}
// "" : a script without a folder of results
string* run_file_of_script(Stack stack, string* const& folder, const long& number) {
  const fs::path in =
      folder->empty() ? "out" / fs::path(script_options().script()).stem() : fs::path(*folder);
  return new_string(stack, burnish::run_file(in.string(), number));
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
  Global.Add("rcStandBy", "(", new SeesVariables<stand_by_here, StepControlHandle*, string*>);
  Global.Add("rcStandbyWrite", "(", new OneOperator2s_<string*, StepControlHandle*, string*>(write_standby));
  Global.Add("rcNoteVariables", "(", new SeesVariables<note_here, long>);
  Global.Add("rcResumeOption", "(", new OneOperator1_<long, long>(resume_asked));
  Global.Add("rcResumable", "(", new OneOperator1_<bool, string*>(resumable));
  Global.Add("rcEndOnly", "(", new OneOperator2_<bool, StepControlHandle*, string*>(read_for_its_end));
  Global.Add("rcRunFile", "(", new OneOperator2s_<string*, string*, long>(run_file_of_script));
  Global.Add("rcOutdated", "(", new OneOperator1_<bool, string*>(outdated));
}

} // namespace burnish
