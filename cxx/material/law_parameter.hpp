#pragma once
// Numbers that a law is given by name, with their meaning, unit and allowed range.
#include <map>
#include <string>
#include <vector>

namespace burnish {

/// One entry of a table of parameters.
struct LawParameter {
  const char* name;        ///< as a script gives it: sigY
  const char* meaning;     ///< in words, for messages and help
  const char* unit;        ///< "stress", "-"
  bool (*allowed)(double); ///< false for what is refused, NaN and infinity included
  const char* expected;    ///< the allowed range in words
};
using LawNumbers = std::map<std::string, double>;

/// Ranges that parameters share.
bool positive(double value);     ///< finite > 0
bool not_negative(double value); ///< finite >= 0

/// The number of that name. @throws std::invalid_argument "where: ..." if it is missing or out of its range
double number_of(const LawNumbers& numbers, const LawParameter& parameter, const char* where);
/// The entry of that name. @throws std::out_of_range if there is none (an error of ours)
const LawParameter& parameter_named(const std::vector<LawParameter>& table, const std::string& name);

} // namespace burnish
