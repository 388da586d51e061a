#pragma once
// How a kind of tool profile is chosen by name and made from named values.
#include "geometry/profile.hpp"
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace burnish {

enum class ShapeValue { NUMBER, NUMBERS, TEXT, FLAG };

struct ShapeParameter {
  std::string name;
  ShapeValue value;
  std::string help; ///< one line: meaning, unit, default
};

/// Values by the names of their parameters.
struct ShapeArguments {
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

/// One kind of profile, for the table in shapes.cpp.
struct ShapeKind {
  std::string example;                    ///< "circle=R"
  std::vector<ShapeParameter> parameters; ///< the first one chooses this kind
  /// @throws std::invalid_argument for values that make no such profile
  std::function<std::shared_ptr<const Profile<2>>(const ShapeArguments&)> make;
  std::string remark = {}; ///< after "takes no ...=", what to do instead
};

} // namespace burnish
