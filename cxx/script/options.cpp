#include "script/options.hpp"
#include "base/error.hpp"
#include "script/text.hpp"
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>

namespace burnish {
namespace {

// FreeFEM reads these anywhere on the command line; one with a value takes the next word.
const std::vector<std::string> FREEFEM{"-f",    "-v",     "-nw",  "-ng",           "-wg",  "-ne",   "-ns",
                                       "-nc",   "-cd",    "-jc",  "-cdtmp",        "-log", "-wait", "-nowait",
                                       "-glut", "-fglut", "-gff", "-check_plugin", "-?"};
const std::vector<std::string> FREEFEM_WITH_VALUE{"-f", "-v", "-glut", "-fglut", "-gff", "-check_plugin"};

constexpr double LARGEST =
    1e15; // of a length, a force, a modulus in any unit; its reciprocal is the smallest
constexpr std::size_t LINE = 110; // letters of the help
constexpr double APART = 1e8;     // of two numbers in one unit; FreeFEM numbers places in a mesh by 31 bits

bool among(const std::vector<std::string>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

bool is_script(const std::string& word) {
  const std::string end = ".edp";
  return word.size() > end.size() && word.compare(word.size() - end.size(), end.size(), end) == 0;
}

} // namespace

ScriptOptions::ScriptOptions(const std::vector<std::string>& words) {
  const auto script = std::find_if(words.begin(), words.end(), is_script);
  if (script == words.end()) return;
  m_script = *script;
  std::vector<std::string> own;
  for (auto word = script + 1; word != words.end(); ++word) {
    if (*word == "-h" || *word == "--help")
      m_help = true;
    else if (!word->empty())
      own.push_back(*word);
  }
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (among(FREEFEM, own[i])) {
      i += among(FREEFEM_WITH_VALUE, own[i]);
      continue;
    }
    m_given.push_back({own[i], {}});
    if (i + 1 < own.size()) m_given.back().value = own[++i];
  }
}

std::string ScriptOptions::folder() const {
  const std::size_t slash = m_script.rfind('/');
  return slash == std::string::npos ? "./" : m_script.substr(0, slash + 1);
}

std::string ScriptOptions::found(const std::string& file) const {
  std::error_code code;
  if (file.empty() || file.find('/') != std::string::npos || std::filesystem::exists(file, code)) return file;
  if (std::filesystem::exists(folder() + file, code)) return folder() + file;
  fail("file", "\"" + file + "\" does not exist, seen from folder " +
                   std::filesystem::current_path().string() + ", nor beside the script, in folder " +
                   folder());
}

// The last one counts.
const std::string* ScriptOptions::find(const std::string& name) const {
  const std::string* value = nullptr;
  for (const Given& given : m_given) {
    if (given.name != name) continue;
    if (!given.value) throw std::invalid_argument("option " + name + " has no value");
    value = &*given.value;
  }
  return value;
}

ScriptOptions::Option& ScriptOptions::note(const std::string& name, const std::string& value,
                                           const std::string& json, const std::string& unit,
                                           const std::string& meaning) {
  require(name.size() > 1 && name[0] == '-', "option", "name", "\"" + name + "\"",
          "a dash and a word, such as -R");
  if (among(FREEFEM, name) || name == "-h" || name == "--help")
    fail("option " + name, "the name is one of FreeFEM's own or asks for help; choose another, such as -" +
                               std::string(2, name.back()));
  const auto known =
      std::find_if(m_options.begin(), m_options.end(), [&](const Option& o) { return o.name == name; });
  const Option option{name, value, json, unit, meaning};
  if (known == m_options.end()) return m_options.emplace_back(option);
  return *known = option;
}

const ScriptOptions::Option& ScriptOptions::number(const std::string& name) const {
  for (const Option& option : m_options)
    if (option.name == name && option.number) return option;
  fail("option " + name, "it has not been read as a number, its range cannot be checked");
}

void ScriptOptions::range(const std::string& names, double least, double most) const {
  std::istringstream list(names);
  for (std::string name; list >> name;) {
    const double value = *number(name).number;
    if (value >= least && value <= most) continue;
    throw std::invalid_argument("option " + name + " is " + json_number(value) + ", expected " +
                                json_number(least) + " to " + json_number(most));
  }
}

void ScriptOptions::positive(const std::string& names) const {
  std::vector<const Option*> together;
  std::istringstream list(names);
  for (std::string name; list >> name;) {
    const Option& option = number(name);
    const double value = *option.number;
    if (!(value > 0 && value <= LARGEST && value >= 1 / LARGEST))
      throw std::invalid_argument(
          "option " + name + " is " + json_number(value) + ", expected > 0" +
          (value > 0 ? ", " + json_number(1 / LARGEST) + " to " + json_number(LARGEST) : ""));
    for (const Option* other : together) // a mesh of such a body is beyond FreeFEM's generator
      if (!option.unit.empty() && option.unit != "-" && option.unit == other->unit &&
          (value > APART * *other->number || *other->number > APART * value))
        throw std::invalid_argument("options " + other->name + " and " + name + " are " + other->json +
                                    " and " + option.json + " " + option.unit +
                                    ", expected at most a factor of " + json_number(APART) + " apart");
    together.push_back(&option);
  }
}

double ScriptOptions::real(const std::string& name, double otherwise, const std::string& unit,
                           const std::string& meaning) {
  const std::string* given = find(name);
  const double value =
      given ? parse_number(*given, "option " + name + " has the value \"" + *given + "\", expected a number")
            : otherwise;
  note(name, json_number(value), json_number(value), unit, meaning).number = value;
  return value;
}

long ScriptOptions::integer(const std::string& name, long otherwise, const std::string& unit,
                            const std::string& meaning) {
  long value = otherwise;
  if (const std::string* given = find(name)) {
    const std::string wrong = "option " + name + " has the value \"" + *given + "\", expected a whole number";
    const double number = parse_number(*given, wrong);
    if (number != std::rint(number) || std::abs(number) > 1e15) throw std::invalid_argument(wrong);
    value = static_cast<long>(number);
  }
  note(name, std::to_string(value), std::to_string(value), unit, meaning).number = static_cast<double>(value);
  return value;
}

std::string ScriptOptions::text(const std::string& name, const std::string& otherwise,
                                const std::string& unit, const std::string& meaning) {
  const std::string* given = find(name);
  const std::string value = given ? *given : otherwise;
  note(name, value, json_text(value), unit, meaning);
  return value;
}

std::string ScriptOptions::first_unknown() const {
  for (const Given& given : m_given) {
    const auto asked = [&](const Option& option) { return option.name == given.name; };
    if (!among(m_accepted, given.name) && std::none_of(m_options.begin(), m_options.end(), asked))
      return given.name;
  }
  return "";
}

void ScriptOptions::refuse_unknown() const {
  const std::string unknown = first_unknown();
  if (unknown.empty()) return;
  std::string list;
  for (const Option& option : m_options) list += " " + option.name;
  throw std::invalid_argument("unknown option " + unknown + ", expected one of" + list);
}

bool ScriptOptions::reads_setting(const std::string& name) {
  if (!given(name) || among(m_settings, name)) return given(name);
  for (const Option& option : m_options)
    if (option.name == name) return false;
  m_settings.push_back(name);
  return true;
}

std::string ScriptOptions::help() const {
  std::size_t name = 0, value = 0, unit = 0;
  for (const Option& option : m_options) {
    name = std::max(name, option.name.size());
    value = std::max(value, option.value.size());
    unit = std::max(unit, option.unit.size());
  }
  std::ostringstream text;
  for (const Option& o : m_options)
    text << "  " << std::left << std::setw(static_cast<int>(name)) << o.name << "  "
         << std::setw(static_cast<int>(value)) << (o.value.empty() ? "\"\"" : o.value) << "  "
         << std::setw(static_cast<int>(unit)) << o.unit << "  " << o.meaning << "\n";
  if (!m_accepted.empty())
    text
        << "settings that go before those of the script (burnish help rcContact, stepcontrol, rcMaterial):\n";
  std::string line;
  for (const std::string& name : m_accepted) {
    if (std::any_of(m_options.begin(), m_options.end(), [&](const Option& o) { return o.name == name; }))
      continue;
    if (line.size() + name.size() > LINE) {
      text << line << "\n";
      line.clear();
    }
    line += " " + name;
  }
  if (!line.empty()) text << line << "\n";
  return text.str();
}

std::string ScriptOptions::json() const {
  std::string text;
  for (const Option& o : m_options)
    text += (text.empty() ? "" : ", ") + json_text(o.name.substr(1)) + ": " + o.json;
  return text;
}

} // namespace burnish
