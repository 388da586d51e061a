#pragma once
// Bad input is an exception with function, name, value and allowed range, in release builds too.
#include <sstream>
#include <stdexcept>
#include <string>

namespace burnish {

/// Something that is refused: "where: what".
class ArgumentError : public std::invalid_argument {
public:
  /// @param function that refuses it, by the core's name
  ArgumentError(const std::string& function, const std::string& what)
      : std::invalid_argument(function + ": " + what), m_said(what) {}
  /// @param text begins with a place that its reader knows
  explicit ArgumentError(const std::string& text) : std::invalid_argument(text), m_said(text) {}
  const std::string& said() const { return m_said; } ///< without the function

private:
  std::string m_said;
};

/// Throws ArgumentError "where: name = value, expected what" unless ok.
template <class Value>
void require(bool ok, const char* where, const char* name, const Value& value, const char* expected) {
  if (ok) return;
  std::ostringstream message;
  message << name << " = " << value << ", expected " << expected;
  throw ArgumentError(where, message.str());
}

/// Throws ArgumentError "where: what" (for conditions that have no single value).
[[noreturn]] inline void fail(const std::string& where, const std::string& what) {
  throw ArgumentError(where, what);
}
/// The same at a place that is no function: x of tool "crank" ...
[[noreturn]] inline void fail_at(const std::string& place, const std::string& what) {
  throw ArgumentError(place + ": " + what);
}

} // namespace burnish
