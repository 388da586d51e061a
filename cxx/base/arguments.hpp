#pragma once
// Named arguments of a script's call, and what a table of kinds (profiles, friction laws) says of them.
#include <map>
#include <string>
#include <vector>

namespace burnish {

enum class ArgumentKind { NUMBER, NUMBERS, TEXT, FLAG };

struct Parameter {
  std::string name;
  ArgumentKind kind;
  std::string help; ///< one line: meaning, unit, default
};

/// Values by the names of their parameters.
struct Arguments {
  std::map<std::string, double> numbers;
  std::map<std::string, std::vector<double>> lists;
  std::map<std::string, std::string> texts;
  std::map<std::string, bool> flags;

  bool has(const std::string& name) const {
    return numbers.count(name) + lists.count(name) + texts.count(name) + flags.count(name) > 0;
  }
  double number(const std::string& name, double otherwise) const { return value(numbers, name, otherwise); }
  std::vector<double> list(const std::string& name) const {
    return value(lists, name, std::vector<double>());
  }
  std::string text(const std::string& name) const { return value(texts, name, std::string()); }
  bool flag(const std::string& name) const { return value(flags, name, false); }

private:
  template <class Value>
  static Value value(const std::map<std::string, Value>& values, const std::string& name, Value otherwise) {
    const auto found = values.find(name);
    return found == values.end() ? otherwise : found->second;
  }
};

} // namespace burnish
