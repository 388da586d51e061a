#include "run/settings.hpp"
#include "base/error.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace burnish {
namespace {

constexpr double ANY = std::numeric_limits<double>::infinity();
constexpr Range POSITIVE{0, ANY, true, "a finite number > 0"};
constexpr Range NOT_NEGATIVE{0, ANY, false, ">= 0"};
constexpr Range FRACTION{0, 1, true, "0 < value < 1"};
constexpr Range BELOW_ONE{0, 0.999999, false, "0 <= value < 1"};
constexpr Range COUNT{1, 1000000, false, "1 to 1000000"};
constexpr Range MEMORY{0, 1000, false, "0 to 1000"};
constexpr Range NONE{0, 1, false, "0 or 1"}; // of a choice or a flag

// Where a setting is, by the path from Settings.
#define AT(path)                                                                                             \
  +[](Settings & all) -> auto& {                                                                             \
    return all.path;                                                                                         \
  }
#define CHOICE(path, ...)                                                                                    \
  Choice {                                                                                                   \
    {__VA_ARGS__}, +[](Settings& all) { return static_cast<int>(all.path); },                                \
        +[](Settings& all, int index) { all.path = static_cast<decltype(all.path)>(index); }                 \
  }

// clang-format off
const std::vector<Setting>& table() { // made when first used: FreeFEM's names of parameters are made before main
  static const std::vector<Setting> list{
  {"tolerance", "rcContact", "-", "5.1", "1e-4", FRACTION,
   "residual over the load; above 1e-2 only with loose=true", AT(iteration.tolerance)},
  {"gaptolerance", "rcContact", "-", "5.1", "1e-6", FRACTION,
   "gap and slip over the spacing of the nodes", AT(iteration.gap_tolerance)},
  {"maxiterations", "rcContact", "-", "5.7", "25", COUNT,
   "bound on the iterations of a step", AT(iteration.max_iterations)},
  {"memory", "rcContact", "-", "5.5", "8", MEMORY,
   "of the Anderson mixing, 0: none", AT(iteration.anderson_memory)},
  {"stepsperfactor", "rcContact", "-", "5.2", "1", COUNT,
   "implicit: steps that one factor of the tangent serves at most; a loss of stability may be noticed so many steps later",
   AT(iteration.steps_per_factor)},
  {"tied", "rcContact", "", "METHOD.md 3.19", "false", NONE,
   "P2: stick and slip at corners, by forces shared with the mid nodes, instead of node by node", AT(iteration.tied)},
  {"terms", "rcContact", "", "METHOD.md 3.6", "\"complete\"", NONE,
   "geometric terms", CHOICE(iteration.terms, "complete", "article", "none")},
  {"frictiontangent", "rcContact", "", "METHOD.md 3.21", "\"consistent\"", NONE,
   "friction in the matrix of an iteration, the result is the same: \"lagged\": on the right-hand side",
   CHOICE(iteration.friction_tangent, "consistent", "lagged")},

  {"dtmax", "stepcontrol", "time", "1", "tend/100", POSITIVE,
   "largest step", AT(control.dt_max)},
  {"dtmin", "stepcontrol", "time", "1", "1e-7 tend", POSITIVE,
   "smallest step: a run that needs a shorter one ends", AT(control.dt_min)},
  {"dtfirst", "stepcontrol", "time", "1", "a quarter of dtmax", POSITIVE,
   "first step: the whole program where nothing flows", AT(control.dt_first)},
  {"stepsperwidth", "stepcontrol", "-", "1", "14", NOT_NEGATIVE,
   "steps at least while the contact rolls its width, 0: no such limit", AT(control.steps_per_width)},
  {"accuracy", "stepcontrol", "-", "1", "0", NOT_NEGATIVE,
   "relative error of the plastic strain increments that the steps are chosen for, S.error; 0: they are not",
   AT(control.accuracy)},
  {"nodesperstep", "stepcontrol", "-", "1", "1", POSITIVE,
   "a rolling step is at least this many node spacings long", AT(stepper.nodes_per_step)},
  {"widthsteps", "stepcontrol", "-", "1", "14", POSITIVE,
   "as stepsperwidth, for narrow contacts: the contact counts as that many spacings wide", AT(stepper.width_steps)},
  {"scheme", "stepcontrol", "", "9", "\"implicit\"", NONE,
   "way through a step", CHOICE(stepper.scheme, "implicit", "event", "article")},
  {"elementevents", "stepcontrol", "", "9.2", "\"default\"", NONE,
   "yield and unloading of points: \"log\": located in every accepted step and logged; \"cut\": the step is cut at them and "
   "at user-defined events; \"default\": none, with scheme article cut",
   CHOICE(stepper.events.elements, "default", "none", "log", "cut")},
  {"eventtolerance", "stepcontrol", "-", "10", "1e-3", POSITIVE,
   "events this close to the earliest one are taken with it, fraction of the step", AT(stepper.events.event_tolerance)},
  {"eventnoise", "stepcontrol", "-", "9.2", "1e-4", POSITIVE,
   "stress that the residual's tolerance leaves, over the yield stress (event steps)", AT(stepper.events.event_noise)},
  {"jumps", "stepcontrol", "-", "9.4", "0.05", BELOW_ONE,
   "implicit: where no equilibrium is near, the body jumps to the next one; the largest part of the tools' work that jumps may "
   "dissipate, 0: none are made, as with a law of the script", AT(stepper.events.jumps)},
  {"maxpieces", "stepcontrol", "-", "9.3", "100", COUNT,
   "article: pieces of a step between events", AT(stepper.events.max_pieces)},
  {"maxretries", "stepcontrol", "-", "9.3", "4", COUNT,
   "article: changes of state at one instant", AT(stepper.events.max_retries)},

  {"update", "rcMaterial", "", "2", "\"substepped\"", NONE,
   "stress update", CHOICE(update.update, "substepped", "single", "euler")},
  {"pathlimit", "rcMaterial", "-", "2", "1.5", NOT_NEGATIVE,
   "curvature of the strain path, 0: straight", AT(update.path_limit)},
  };
  return list;
}
// clang-format on

} // namespace

bool Range::holds(double value) const {
  return open ? value > least && value < most : value >= least && value <= most;
}

std::string Choice::list() const {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + ("\"" + words[i] + "\"");
  return text;
}

const std::vector<Setting>& settings() { return table(); }

const Setting& setting(const std::string& name) {
  for (const Setting& one : table())
    if (name == one.name) return one;
  fail("setting", "there is none named \"" + name + "\"");
}

void set_number(Settings& all, const Setting& setting, double value, const char* where,
                const std::string& shown) {
  if (const auto real = std::get_if<double& (*)(Settings&)>(&setting.member)) {
    require(setting.range.holds(value), where, shown.c_str(), value, setting.range.text);
    (*real)(all) = value;
    return;
  }
  require(value == std::rint(value), where, shown.c_str(), value, "a whole number");
  require(setting.range.holds(value), where, shown.c_str(), static_cast<long>(value), setting.range.text);
  if (const auto integer = std::get_if<int& (*)(Settings&)>(&setting.member))
    (*integer)(all) = static_cast<int>(value);
  else
    std::get<bool& (*)(Settings&)>(setting.member)(all) = value != 0;
}

void set_choice(Settings& all, const Setting& setting, const std::string& word, const char* where) {
  const Choice& choice = std::get<Choice>(setting.member);
  const auto found = std::find(choice.words.begin(), choice.words.end(), word);
  if (found == choice.words.end())
    fail(where, "unknown " + std::string(setting.name) + " \"" + word + "\", expected " + choice.list());
  choice.set(all, static_cast<int>(found - choice.words.begin()));
}

} // namespace burnish
