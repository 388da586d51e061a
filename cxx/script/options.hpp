#pragma once
// Options of a script, -name value: read, checked, listed, refused if unknown.
#include <optional>
#include <string>
#include <vector>

namespace burnish {

class ScriptOptions {
public:
  /// One that was asked for, as used. json: the value in JSON; number: of one that was read as a number.
  struct Option {
    std::string name, value, json, unit, meaning;
    std::optional<double> number = {};
  };

  /// @param words all words of the command line; those after the first that ends in ".edp" are the script's
  explicit ScriptOptions(const std::vector<std::string>& words);
  const std::string& script() const { return m_script; } ///< path of the script, "" if there is none
  std::string folder() const;                            ///< of the script, with a slash; "./" if it is here
  /// Where a file that the script names without a folder is: here, else beside the script.
  /// @throws std::invalid_argument if it is in neither folder
  std::string found(const std::string& file) const;

  bool given(const std::string& name) const { return find(name) != nullptr; } ///< it is among the words
  /// Name of the first word that is no option that was asked for or accepted, nor FreeFEM's own; "" if there is none.
  std::string first_unknown() const;
  /// Value of an option, or the default. @param name with its dash; @param unit, meaning for the help; may be empty
  /// @throws std::invalid_argument for a name that FreeFEM takes for itself, an option without a value, a value that is
  ///         no number, or no whole one
  double real(const std::string& name, double otherwise, const std::string& unit, const std::string& meaning);
  long integer(const std::string& name, long otherwise, const std::string& unit, const std::string& meaning);
  std::string text(const std::string& name, const std::string& otherwise, const std::string& unit,
                   const std::string& meaning);

  /// @param names of numbers that were read, "-R -a -E"; @param least, most the values allowed, both included
  /// @throws std::invalid_argument for a value outside, and a name that is none of a number
  void range(const std::string& names, double least, double most) const;
  /// The same, > 0, 1e-15 to 1e15; those in the same unit, lengths of one body, at most a factor of 1e8 apart.
  void positive(const std::string& names) const;

  /// An option that needs not be asked for: it is read later, by reads_setting.
  void accept(const std::string& name) { m_accepted.push_back(name); }
  /// A setting of that name is among the words, and the script has not asked for it itself.
  bool reads_setting(const std::string& name);
  /// @throws std::invalid_argument naming a word that is no option that was asked for or accepted, and those that are
  void refuse_unknown() const;
  bool wants_help() const { return m_help; } ///< -h or --help is among the words
  /// One line an option: name, value, unit, meaning.
  std::string help() const;
  /// The values used: "name": value, ... without braces.
  std::string json() const;
  const std::vector<Option>& options() const { return m_options; }

private:
  struct Given {
    std::string name;
    std::optional<std::string> value; // none after the last word
  };
  const std::string* find(const std::string& name) const;
  Option& note(const std::string& name, const std::string& value, const std::string& json,
               const std::string& unit, const std::string& meaning);
  const Option& number(const std::string& name) const;

  std::string m_script;
  std::vector<Given> m_given;                      // words of the script in pairs, without FreeFEM's own
  std::vector<Option> m_options;                   // asked for
  std::vector<std::string> m_accepted, m_settings; // m_settings: those of them that were asked for as such
  bool m_help = false;
};

} // namespace burnish
