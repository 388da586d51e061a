#include "material/law_parameter.hpp"
#include "base/error.hpp"
#include <cmath>

namespace burnish {

bool positive(double value) { return value > 0 && std::isfinite(value); }
bool not_negative(double value) { return value >= 0 && std::isfinite(value); }

double number_of(const LawNumbers& numbers, const LawParameter& parameter, const char* where) {
  const auto found = numbers.find(parameter.name);
  if (found == numbers.end())
    fail(where, std::string("parameter ") + parameter.name + " is missing (" + parameter.meaning + ", " +
                    parameter.expected + ")");
  require(parameter.allowed(found->second), where, parameter.name, found->second, parameter.expected);
  return found->second;
}

const LawParameter& parameter_named(const std::vector<LawParameter>& table, const std::string& name) {
  for (const LawParameter& parameter : table)
    if (parameter.name == name) return parameter;
  throw std::out_of_range("no law parameter " + name);
}

} // namespace burnish
