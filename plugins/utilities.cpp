// Small things a step loop needs from the machine, and the step control.
//   rcLastError(0)                     text of the last error, once;  rcFail(text) ends the script with it, unless caught
//   rcWallTime(0), rcCatchInterrupt(0), rcInterrupted(0), rcBlas(0), rcReferenceBlas(0), rcVersions(0)
//   rcNumber(name, text), rcJson(number or text), rcMakeFolder(path)
//   stepcontrol S(tend, dtmax=..., dtmin=..., stepsperwidth=14, output=times);
//     S.propose(width, speed), S.accepted(), S.rejected() (false: below the floor), S.cut(f), S.t, S.dt, S.finished
#include "base/error.hpp"
#include "base/version.hpp"
#include "named.hpp"
#include "solver/blas_info.hpp"
#include "stepping/step_control.hpp"
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <iomanip>
#include <utility>

namespace burnish {
namespace {

volatile std::sig_atomic_t interrupted = 0;
void note_signal(int) {
  if (interrupted) std::_Exit(130); // asked twice: leave at once
  interrupted = 1;
}

// Taken, not only read: an error of FreeFEM's own leaves no text, and must not be told by an older one.
string* last_error_text(Stack stack, const long&) {
  return new_string(stack, std::exchange(last_error(), std::string()));
}
bool fail_with(string* const& message) { throw PluginError(*message); }
double wall_time(const long&) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
bool catch_interrupt(const long&) {
  std::signal(SIGINT, note_signal);
  std::signal(SIGTERM, note_signal);
  return true;
}
bool was_interrupted(const long&) { return interrupted != 0; }
string* blas(Stack stack, const long&) { return new_string(stack, blas_name()); }
// JSON object of the versions in use. FreeFEM's is a script's global.
string* versions(Stack stack, const long&) {
  std::ostringstream text;
  text << "{\"burnish\": \"" << BURNISH_VERSION << "\", \"eigen\": \"" << EIGEN_WORLD_VERSION << "."
       << EIGEN_MAJOR_VERSION << "." << EIGEN_MINOR_VERSION << "\", \"sparse\": \""
       << sparse_solver_versions() << "\", \"blas\": \"" << blas_name() << "\", \"compiler\": \""
       << __VERSION__ << "\"}";
  return new_string(stack, text.str());
}
bool reference_blas(const long&) { return is_reference_blas(); }
double number(string* const& name, string* const& text) {
  return guarded([&] {
    char* end = nullptr;
    const double value = std::strtod(text->c_str(), &end);
    if (text->empty() || *end != 0 || !std::isfinite(value))
      fail("option", *name + " has the value \"" + *text + "\", expected a number");
    return value;
  });
}
// JSON: numbers in the fewest digits that give them back, null for NaN and Inf; texts in quotes.
string* json_number(Stack stack, const double& value) {
  if (!std::isfinite(value)) return new_string(stack, "null");
  char text[40];
  for (int digits = 6; digits <= 17; ++digits) {
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    if (std::strtod(text, nullptr) == value) break;
  }
  return new_string(stack, text);
}
string* json_text(Stack stack, string* const& value) {
  std::ostringstream text;
  text << '"';
  for (const char c : *value)
    if (c == '"' || c == '\\')
      text << '\\' << c;
    else if (static_cast<unsigned char>(c) < 0x20)
      text << "\\u00" << std::hex << std::setw(2) << std::setfill('0') << static_cast<int>(c) << std::dec;
    else
      text << c;
  text << '"';
  return new_string(stack, text.str());
}
bool make_folder(string* const& path) {
  return guarded([&] {
    std::error_code code;
    std::filesystem::create_directories(*path, code);
    const std::string probe = *path + "/.writable";
    bool ok = false;
    int reason = 0;
    std::FILE* f = std::fopen(probe.c_str(), "w");
    if (!f) reason = errno;
    if (f) {
      std::fclose(f);
      std::filesystem::remove(probe, code);
      ok = true;
    }
    if (!ok)
      fail("rcMakeFolder", "the output folder \"" + *path + "\" cannot be written: " + std::strerror(reason));
    return true;
  });
}

struct ControlObject {
  static constexpr const char* TYPE = "stepcontrol";
  std::unique_ptr<StepControl> control;
};
using ControlHandle = Handle<ControlObject>;
struct Construct {
  static const int n = 4;
  static basicAC_F0::name_and_type names[n];
  static ControlHandle* call(const Named& a, ControlHandle* handle, double t_end) {
    handle->init();
    StepControlOptions options;
    options.t_end = t_end;
    for (const char* name : {"dtmax", "dtmin"})
      if (a.has(name))
        require(std::isfinite(a.real(name, 0)) && a.real(name, 0) > 0, "stepcontrol", name, a.real(name, 0),
                "a finite number > 0");
    options.dt_max = a.real("dtmax", options.dt_max);
    options.dt_min = a.real("dtmin", options.dt_min);
    options.steps_per_width = a.real("stepsperwidth", options.steps_per_width);
    if (a.has("output")) {
      const Eigen::VectorXd times = to_vector(a.array("output"), "stepcontrol", "output");
      options.output_times.assign(times.data(), times.data() + times.size());
    }
    auto object = std::make_shared<ControlObject>();
    object->control = std::make_unique<StepControl>(0, options);
    handle->set(std::move(object));
    return handle;
  }
};
basicAC_F0::name_and_type Construct::names[] = {{"dtmax", &typeid(double)},
                                                {"dtmin", &typeid(double)},
                                                {"stepsperwidth", &typeid(double)},
                                                {"output", &typeid(KN_<double>)}};

struct ProposeTag {};
struct AcceptedTag {};
struct RejectedTag {};
struct CutTag {};
StepControl& proposed(ControlHandle* handle, const char* where) {
  StepControl& control = *handle->get().control;
  if (control.dt() <= 0) fail(where, "there is no step yet, call propose first");
  return control;
}
double propose(const Method<ControlHandle, ProposeTag>& m, const double& width, const double& speed) {
  return guarded([&] { return m->get().control->propose(width, speed); });
}
bool accepted(const Method<ControlHandle, AcceptedTag>& m) {
  return guarded([&] { return proposed(m.object, "stepcontrol.accepted").accepted(), true; });
}
bool rejected(const Method<ControlHandle, RejectedTag>& m) {
  return guarded([&] { return proposed(m.object, "stepcontrol.rejected").rejected(); });
}
double cut(const Method<ControlHandle, CutTag>& m, const double& f) {
  return guarded([&] {
    require(f > 0 && f <= 1, "stepcontrol.cut", "fraction", f, "0 < fraction <= 1");
    proposed(m.object, "stepcontrol.cut").cut(f);
    return m->get().control->dt();
  });
}
double time_of(ControlHandle* const& h) { return h->get().control->time(); }
double dt_of(ControlHandle* const& h) { return h->get().control->dt(); }
bool finished(ControlHandle* const& h) { return h->get().control->finished(); }
bool at_output(ControlHandle* const& h) { return h->get().control->at_output(); }

} // namespace

void register_tools_of_the_trade() {
  using H = ControlHandle;
  Global.Add("rcLastError", "(", new OneOperator1s_<string*, long>(last_error_text));
  Global.Add("rcFail", "(", new OneOperator1_<bool, string*>(fail_with));
  Global.Add("rcJson", "(", new OneOperator1s_<string*, double>(json_number));
  Global.Add("rcJson", "(", new OneOperator1s_<string*, string*>(json_text));
  Global.Add("rcWallTime", "(", new OneOperator1_<double, long>(wall_time));
  Global.Add("rcCatchInterrupt", "(", new OneOperator1_<bool, long>(catch_interrupt));
  Global.Add("rcInterrupted", "(", new OneOperator1_<bool, long>(was_interrupted));
  Global.Add("rcBlas", "(", new OneOperator1s_<string*, long>(blas));
  Global.Add("rcVersions", "(", new OneOperator1s_<string*, long>(versions));
  Global.Add("rcReferenceBlas", "(", new OneOperator1_<bool, long>(reference_blas));
  Global.Add("rcNumber", "(", new OneOperator2_<double, string*, string*>(number));
  Global.Add("rcMakeFolder", "(", new OneOperator1_<bool, string*>(make_folder));
  Dcl_Type<H*>(InitP<H>, Destroy<H>);
  zzzfff->Add("stepcontrol", atype<H*>());
  TheOperators->Add("<-", new NamedOperator<Construct, H*, H*, double>);
  add_method<H, ProposeTag>(
      "propose", [] { return new OneOperator3_<double, Method<H, ProposeTag>, double, double>(propose); });
  add_method<H, AcceptedTag>("accepted",
                             [] { return new OneOperator1_<bool, Method<H, AcceptedTag>>(accepted); });
  add_method<H, RejectedTag>("rejected",
                             [] { return new OneOperator1_<bool, Method<H, RejectedTag>>(rejected); });
  add_method<H, CutTag>("cut", [] { return new OneOperator2_<double, Method<H, CutTag>, double>(cut); });
  Add<H*>("t", ".", new OneOperator1_<double, H*>(time_of));
  Add<H*>("dt", ".", new OneOperator1_<double, H*>(dt_of));
  Add<H*>("finished", ".", new OneOperator1_<bool, H*>(finished));
  Add<H*>("atoutput", ".", new OneOperator1_<bool, H*>(at_output));
}

} // namespace burnish
