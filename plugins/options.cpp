// Options of a script, -name value after its name on the command line; read all of them in one block.
//   > real R = rcReal("-R", 15e-3, "m", "radius of the roller");  int n = rcInt("-n", 10);
//   > rcPositive("-R");  rcRange("-n", 1, 1000);  rcOptionsEnd();
//   rcReal(name, otherwise), rcInt(name, otherwise), rcText(name, otherwise)   the option's value, or its default
//     name      with its dash | | | a dash and a word, none of FreeFEM's own options
//     otherwise   the default
//   rcReal(name, otherwise, unit, meaning), rcInt(name, otherwise, unit, meaning)   the same, listed by -h
//     name      with its dash | | | a dash and a word, none of FreeFEM's own options
//     otherwise   the default
//     unit      text for the help, "-" without one
//     meaning   text for the help
//   rcText(name, otherwise, unit, meaning)   the same of a text
//     name      with its dash | | | a dash and a word, none of FreeFEM's own options
//     otherwise   the default
//     unit      text for the help, "" without one
//     meaning   text for the help
//   rcReal(name), rcInt(name), rcText(name)   refused: the default is missing
//     name      with its dash
//     ! arguments, expected 2: name, default
//   rcReal(name, otherwise, unit), rcInt(name, otherwise, unit), rcText(name, otherwise, unit)   refused: the meaning is missing
//     name      with its dash
//     otherwise   the default
//     unit      text for the help
//     ! arguments, expected 2: name, default
//   rcRange(names, least, most)   refuses values outside
//     names     "-n -nx", options read before
//     least     smallest value allowed
//     most      largest one
//     ! it has not been read as a number, its range cannot be checked
//   rcPositive(names)   refuses values that are not > 0, or in one unit and more than a factor of 1e8 apart
//     names     "-R -E", options read before
//   rcOptionsEnd()   refuses unknown options; those named like a setting of rcContact, stepcontrol or rcMaterial, -stepsperfactor 2, go
//       before what the script gives there; with -h the help is printed and the script ends there, with -options list
//       all options with their values, as one line of JSON. A script without it that is given options: status 20, before it
//       runs if it reads none, at its end if it has not read that one; unless it has ARGV or PETSc, which take words, too
//   rcOptionsEnd(dummy)   the same, of older scripts
//     dummy     not read
//   rcOptionUsed(name, words)   whether the script uses one of the names, outside of comments; if not, the option is refused
//     name      of an option that would have no say otherwise
//     words     "rcScheme", or several
//     ! the script does not use it
//   rcScriptFolder(dummy)   folder of the script with its slash, "cases/rolling/"
//     dummy     not read
#include "base/error.hpp"
#include "checkpoint.hpp"
#include "leave.hpp"
#include "plugin.hpp"
#include "script/words.hpp"
#include "script_options.hpp"
#include "settings.hpp"
#include <cstdlib>

extern KN<String>* pkarg; // FreeFEM's ARGV

namespace burnish {

ScriptOptions& script_options() {
  static ScriptOptions read = [] {
    std::vector<std::string> words;
    for (long i = 0; pkarg && i < pkarg->N(); ++i)
      words.push_back(static_cast<const string&>((*pkarg)[static_cast<int>(i)]));
    return ScriptOptions(words);
  }();
  return read;
}

namespace {

// FreeFEM itself says that no function fits, and ends with status 1.
[[noreturn]] void other_words(const std::string& name, int number) {
  fail("option " + name, "read with " + std::to_string(number) +
                             " arguments, expected 2: name, default; or 4: name, default, unit, meaning");
}
template <class T> T name_alone(string* const& name) {
  return guarded([&]() -> T { other_words(*name, 1); });
}
template <class T> T without_meaning(string* const& name, const T&, string* const&) {
  return guarded([&]() -> T { other_words(*name, 3); });
}
template <class T> void refuse_other_words(const char* name) {
  Global.Add(name, "(", new OneOperator1_<T, string*>(name_alone<T>));
  Global.Add(name, "(", new OneOperator3_<T, string*, T, string*>(without_meaning<T>));
}
double real_option(string* const& name, const double& otherwise) {
  return guarded([&] { return script_options().real(*name, otherwise, "", ""); });
}
double real_with_help(string* const& name, const double& otherwise, string* const& unit,
                      string* const& meaning) {
  return guarded([&] { return script_options().real(*name, otherwise, *unit, *meaning); });
}
long int_option(string* const& name, const long& otherwise) {
  return guarded([&] { return script_options().integer(*name, otherwise, "", ""); });
}
long int_with_help(string* const& name, const long& otherwise, string* const& unit, string* const& meaning) {
  return guarded([&] { return script_options().integer(*name, otherwise, *unit, *meaning); });
}
string* text_option(Stack stack, string* const& name, string* const& otherwise) {
  return guarded([&] { return new_string(stack, script_options().text(*name, *otherwise, "", "")); });
}
string* text_with_help(Stack stack, string* const& name, string* const& otherwise, string* const& unit,
                       string* const& meaning) {
  return guarded(
      [&] { return new_string(stack, script_options().text(*name, *otherwise, *unit, *meaning)); });
}
bool options_end() {
  return guarded([&] {
    const std::string list =
        script_options().text("-options", "", "", "list: prints all options with their values, as JSON");
    script_options().refuse_unknown();
    if (script_options().wants_help()) {
      cout << "options of " << script_options().script() << ", with defaults and units:\n"
           << script_options().help();
      leave(0);
    }
    if (!list.empty()) {
      cout << "{" << script_options().json() << "}\n";
      leave(0);
    }
    return true;
  });
}
bool options_end_of_older(const long&) { return options_end(); }
bool uses(const std::string& words) {
  const char* path = std::getenv("FF_INCLUDEPATH");
  return script_uses(script_options().script(), words, path ? path : "");
}
bool option_used(string* const& name, string* const& words) {
  return guarded([&] {
    const bool used = uses(*words);
    if (!used && script_options().given(*name))
      throw std::invalid_argument("option " + *name + " is given, but the script does not use it: " + *words +
                                  " occurs nowhere in " + script_options().script());
    return used;
  });
}
bool range(string* const& names, const double& least, const double& most) {
  return guarded([&] { return script_options().range(*names, least, most), true; });
}
bool positive(string* const& names) {
  return guarded([&] { return script_options().positive(*names), true; });
}
string* script_folder(Stack stack, const long&) { return new_string(stack, script_options().folder()); }

// The script has been given options, reads some, and has no rcOptionsEnd; found while it is loaded, as a search at its end may not be.
bool never_ended = false;

// What nothing reads would change nothing, silently.
void refuse_options_of_no_reader() {
  accept_settings();
  accept_checkpoint_options();
  const ScriptOptions& options = script_options();
  const std::string first = options.wants_help() ? "-h" : options.first_unknown();
  if (first.empty() || uses("rcOptionsEnd ARGV getARGV PETSc SLEPc hpddm")) return;
  never_ended = !options.wants_help() && uses("rcReal rcInt rcText");
  if (never_ended) return; // the end of the script will show which
  cout << "burnish: option " << first << " is given, but " << options.script()
       << (options.wants_help() ? " does not list its options" : " reads no options")
       << ": expected rcReal, rcInt or rcText for each of them, then rcOptionsEnd()" << endl;
  leave(20);
}

// FreeFEM says "syntax error" alone.
void refuse_names_of_types() {
  const std::string& script = script_options().script();
  const std::string found = declared_name(script, "tool contact material stepcontrol");
  if (found.empty()) return;
  cout << "burnish: " << script << ": " << found
       << " is the name of a type of Burnish (tool, contact, material, stepcontrol): "
       << "expected another name for what is declared there, such as " << found.substr(0, found.find(' '))
       << "1" << endl;
  leave(20);
}

} // namespace

bool ignores_option() {
  if (!never_ended) return false;
  try {
    script_options().refuse_unknown();
  } catch (const std::exception& unknown) {
    cout << "burnish: " << unknown.what() << "; it was ignored, as " << script_options().script()
         << " has no rcOptionsEnd() after its options" << endl;
    return true;
  }
  return false;
}

void register_options() {
  refuse_names_of_types();
  refuse_options_of_no_reader();
  Global.Add("rcReal", "(", new OneOperator2_<double, string*, double>(real_option));
  Global.Add("rcReal", "(", new OneOperator4_<double, string*, double, string*, string*>(real_with_help));
  Global.Add("rcInt", "(", new OneOperator2_<long, string*, long>(int_option));
  Global.Add("rcInt", "(", new OneOperator4_<long, string*, long, string*, string*>(int_with_help));
  Global.Add("rcText", "(", new OneOperator2s_<string*, string*, string*>(text_option));
  Global.Add("rcText", "(", new OneOperator4s_<string*, string*, string*, string*, string*>(text_with_help));
  refuse_other_words<double>("rcReal");
  refuse_other_words<long>("rcInt");
  refuse_other_words<string*>("rcText");
  Global.Add("rcRange", "(", new OneOperator3_<bool, string*, double, double>(range));
  Global.Add("rcPositive", "(", new OneOperator1_<bool, string*>(positive));
  Global.Add("rcOptionUsed", "(", new OneOperator2_<bool, string*, string*>(option_used));
  Global.Add("rcOptionsEnd", "(", new OneOperator0<bool>(options_end),
             new OneOperator1_<bool, long>(options_end_of_older));
  Global.Add("rcScriptFolder", "(", new OneOperator1s_<string*, long>(script_folder));
}

} // namespace burnish
