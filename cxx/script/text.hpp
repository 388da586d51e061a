#pragma once
// Numbers and texts as a script reads and writes them.
#include <string>

namespace burnish {

/// The number that a text is. @throws std::invalid_argument "what" if it is none, or not finite
double parse_number(const std::string& text, const std::string& what);

/// JSON: a number in the fewest digits that give it back, null for NaN and Inf; a text in quotes.
std::string json_number(double value);
std::string json_text(const std::string& text);

} // namespace burnish
