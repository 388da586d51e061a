#pragma once
// Words and numbers as one text.
#include <sstream>
#include <string>

namespace burnish {

/// All parts one after another, as a stream prints them: numbers with six digits.
template <class... Parts> std::string sentence(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

/// "x y" of a place: a vector of any kind.
template <class Place> std::string place_text(const Place& x) {
  std::ostringstream text;
  for (std::size_t i = 0; i < static_cast<std::size_t>(x.size()); ++i) text << (i ? " " : "") << x[i];
  return text.str();
}

} // namespace burnish
