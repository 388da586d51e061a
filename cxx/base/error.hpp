#pragma once
// Bad input is an exception with function, name, value and allowed range, in release builds too.
#include <sstream>
#include <stdexcept>
#include <string>

namespace burnish {

/// Throws std::invalid_argument "where: name = value, expected what" unless ok.
template <class Value>
void require(bool ok, const char* where, const char* name, const Value& value, const char* expected) {
  if (ok) return;
  std::ostringstream message;
  message << where << ": " << name << " = " << value << ", expected " << expected;
  throw std::invalid_argument(message.str());
}

/// Throws std::invalid_argument "where: what" (for conditions that have no single value).
[[noreturn]] inline void fail(const std::string& where, const std::string& what) {
  throw std::invalid_argument(where + ": " + what);
}

} // namespace burnish
