#include "script/text.hpp"
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace burnish {

double parse_number(const std::string& text, const std::string& what) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != 0 || !std::isfinite(value)) throw std::invalid_argument(what);
  return value;
}

std::string json_number(double value) {
  if (!std::isfinite(value)) return "null";
  char text[40];
  for (int digits = 6; digits <= 17; ++digits) {
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    if (std::strtod(text, nullptr) == value) break;
  }
  return text;
}

std::string json_text(const std::string& text) {
  std::ostringstream json;
  json << '"';
  for (const char c : text)
    if (c == '"' || c == '\\')
      json << '\\' << c;
    else if (static_cast<unsigned char>(c) < 0x20)
      json << "\\u00" << std::hex << std::setw(2) << std::setfill('0') << static_cast<int>(c) << std::dec;
    else
      json << c;
  json << '"';
  return json.str();
}

} // namespace burnish
