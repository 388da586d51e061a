// Small things that a script needs from the machine.
//   rcLastError(dummy)   text of the last error, once
//     dummy     not read
//   rcFail(text)   ends the script with this error and exit status 20, unless caught
//     text      what is wrong, and what is expected
//   rcFail(text, status)   the same with another exit status
//     text      what is wrong, and what is expected
//     status    exit status | - | 20
//   rcCaughtStatus(dummy)   in a catch block: the exit status that the error would have had | -
//     dummy     not read
//   rcCaughtExit(dummy)   in a catch block: whether it is exit(n) of the script
//     dummy     not read
//   rcCatchInterrupt(dummy)   Ctrl-C, SIGTERM, SIGHUP only set rcInterrupted, until rcReleaseInterrupt; again a second
//       later: leaves, status 130
//     dummy     not read
//   rcReleaseInterrupt(dummy)   they end the script again
//     dummy     not read
//   rcInterrupted(dummy)   whether one came
//     dummy     not read
//   rcWallTime(dummy)   a clock, for differences | s
//     dummy     not read
//   rcReferenceBlas(dummy)   it is the slow reference one
//     dummy     not read
//   rcTerminal(dummy)   output goes to a terminal
//     dummy     not read
//   rcErasedLine(dummy)   what erases the line of a terminal
//     dummy     not read
//   rcLeave(status)   ends the script with this exit status and no more words
//     status    exit status | -
//   rcOwe(status)   the exit status if the script ends by itself; 0 takes it back
//     status    exit status | -
//   internal: rcNoMore
#include "leave.hpp"
#include "named.hpp"
#include "output/summary.hpp"
#include "parallel/ranks.hpp"
#include "solver/blas_info.hpp"
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <unistd.h>
#include <utility>

namespace burnish {
namespace {

volatile std::sig_atomic_t interrupted = 0;
bool catching = false; // a run looks at it
timespec first_signal{};
constexpr double SAME_REQUEST = 1; // [s] timeout(1) signals the program and its group
constexpr double PATIENCE = 5;     // [s] a step may take to its end and checkpoint when the run shall end
double since_first_signal() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec - first_signal.tv_sec) +
         1e-9 * static_cast<double>(now.tv_nsec - first_signal.tv_nsec);
}
void note_signal(int) {
  if (!interrupted) clock_gettime(CLOCK_MONOTONIC, &first_signal);
  interrupted = 1;
  if (since_first_signal() > SAME_REQUEST) std::_Exit(130); // asked twice: leave at once
}

// Taken, not only read: an error of FreeFEM's own leaves no text, and must not be reported by the text of an older one.
string* last_error_text(Stack stack, const long&) {
  return new_string(stack, std::exchange(last_error(), std::string()));
}
bool fail_with_status(string* const& message, const long& status) {
  throw PluginError(message->empty() ? "rcFail without a text" : *message, static_cast<int>(status));
}
// A name that is no more: an error where the script is read, before any of it runs.
class NoMore : public OneOperator {
public:
  NoMore() : OneOperator(atype<bool>(), atype<const char*>()) {}
  E_F0* code(const basicAC_F0& arguments) const override {
    throw PluginError(GetAny<const char*>((*arguments[0].LeftValue())(nullptr)));
  }
};
bool fail_with(string* const& message) { return fail_with_status(message, BAD_INPUT); }
// FreeFEM runs a script's catch block while the exception is there.
long caught_status(const long&) {
  try {
    if (const auto caught = std::current_exception()) std::rethrow_exception(caught);
  } catch (const PluginError& error) {
    return error.errcode();
  } catch (const ErrorExit& error) {
    return error.errcode();
  } catch (...) {
  }
  return BAD_INPUT;
}
bool caught_exit(const long&) {
  try {
    if (const auto caught = std::current_exception()) std::rethrow_exception(caught);
  } catch (const ErrorExit&) {
    return true;
  } catch (...) {
  }
  return false;
}
double wall_time(const long&) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
// SIGUSR1: what mpirun hands on to all ranks, burnish -np
constexpr int SIGNALS[] = {SIGINT, SIGTERM, SIGUSR1, SIGHUP}, NUM_SIGNALS = 4;
void (*handlers[])(int) = {SIG_DFL, SIG_DFL, SIG_DFL, SIG_DFL};
bool catch_interrupt(const long&) {
  interrupted = 0;
  catching = true;
  for (int k = 0; k < NUM_SIGNALS; ++k) handlers[k] = std::signal(SIGNALS[k], note_signal);
  if (handlers[NUM_SIGNALS - 1] == SIG_IGN) std::signal(SIGHUP, SIG_IGN); // nohup
  return true;
}
bool release_interrupt(const long&) {
  catching = false;
  for (int k = 0; k < NUM_SIGNALS; ++k) std::signal(SIGNALS[k], handlers[k]);
  return true;
}
bool was_interrupted(const long&) { return interrupt_came(); }
// FreeFEM's own version is a script's global.
bool reference_blas(const long&) { return is_reference_blas(); }
bool leave_script(const long& status) { leave(static_cast<int>(status)); }
bool owe_status(const long& status) {
  owe(static_cast<int>(status));
  return true;
}
// FreeFEM's texts know no escape character.
string* erased_line(Stack stack, const long&) { return new_string(stack, "\r\033[K"); }
// mpirun has one for its processes whatever its own output is; .ci/burnish.in says what that is.
bool is_terminal(const long&) {
  return isatty(STDOUT_FILENO) != 0 && (ranks().size() == 1 || std::getenv("BURNISH_TERMINAL"));
}

} // namespace

bool interrupt_came() { return ranks().least(interrupted ? 0 : 1) == 0; }
bool interrupt_is_old() { return ranks().least(interrupted && since_first_signal() > PATIENCE ? 0 : 1) == 0; }
bool run_catches_interrupt() { return catching; }

void register_tools_of_the_trade() {
  Global.Add("rcLastError", "(", new OneOperator1s_<string*, long>(last_error_text));
  Global.Add("rcNoMore", "(", new NoMore);
  Global.Add("rcFail", "(", new OneOperator1_<bool, string*>(fail_with));
  Global.Add("rcFail", "(", new OneOperator2_<bool, string*, long>(fail_with_status));
  Global.Add("rcCaughtStatus", "(", new OneOperator1_<long, long>(caught_status));
  Global.Add("rcCaughtExit", "(", new OneOperator1_<bool, long>(caught_exit));
  Global.Add("rcWallTime", "(", new OneOperator1_<double, long>(wall_time));
  Global.Add("rcCatchInterrupt", "(", new OneOperator1_<bool, long>(catch_interrupt));
  Global.Add("rcReleaseInterrupt", "(", new OneOperator1_<bool, long>(release_interrupt));
  Global.Add("rcInterrupted", "(", new OneOperator1_<bool, long>(was_interrupted));
  Global.Add("rcReferenceBlas", "(", new OneOperator1_<bool, long>(reference_blas));
  Global.Add("rcLeave", "(", new OneOperator1_<bool, long>(leave_script));
  Global.Add("rcOwe", "(", new OneOperator1_<bool, long>(owe_status));
  Global.Add("rcErasedLine", "(", new OneOperator1s_<string*, long>(erased_line));
  Global.Add("rcTerminal", "(", new OneOperator1_<bool, long>(is_terminal));
}

} // namespace burnish
