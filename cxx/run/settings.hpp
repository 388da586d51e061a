#pragma once
// What a script can set of a run, in one table: the named parameters of rcContact, stepcontrol and rcMaterial, -name on the
// command line, the reference and its check are made of it. A new setting is a member of an options structure and a row.
#include "iteration/options.hpp"
#include "material/update_options.hpp"
#include "run/stepper.hpp"
#include <string>
#include <variant>
#include <vector>

namespace burnish {

struct Settings {
  IterationOptions iteration;
  StepControlOptions control;
  StepperOptions stepper;
  UpdateOptions update;
};

/// Numbers allowed, and what messages and the reference say of them.
struct Range {
  double least, most;
  bool open; ///< the bounds do not belong to it
  const char* text;
  bool holds(double value) const;
};

/// One of several words; the words stand in the order of the enumerators.
struct Choice {
  std::vector<std::string> words;
  int (*get)(Settings&);
  void (*set)(Settings&, int);
  std::string list() const; ///< "a", "b" or "c"
};

struct Setting {
  const char *name, *owner;   ///< named parameter `name` of rcContact, stepcontrol or rcMaterial
  const char *unit, *section; ///< "-": none; of ALGORITHMS.md
  const char* otherwise;      ///< the default, in words where 0 stands for it
  Range range;                ///< of a number
  const char* meaning;
  std::variant<double& (*)(Settings&), int& (*)(Settings&), bool& (*)(Settings&), Choice> member;
};

const std::vector<Setting>& settings();
/// @throws std::invalid_argument for a name that no setting has
const Setting& setting(const std::string& name);

/// @param where of the error: "contact", "option"; @param shown name in its text, "tolerance", "-tolerance"
/// @throws std::invalid_argument for a value outside of the range, a number that is not whole
void set_number(Settings& settings, const Setting& setting, double value, const char* where,
                const std::string& shown);
/// The same of a choice. @throws std::invalid_argument for another word
void set_choice(Settings& settings, const Setting& setting, const std::string& word, const char* where);

} // namespace burnish
