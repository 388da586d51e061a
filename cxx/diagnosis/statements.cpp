#include "diagnosis/statements.hpp"

namespace burnish {

const char* name_of(StatementKind kind) {
  switch (kind) {
  case StatementKind::NEEDED:
    return "needed and not modelled";
  case StatementKind::NOT_NEEDED:
    return "modelled and not needed";
  case StatementKind::LEAN:
    break;
  }
  return "lean";
}

std::string short_number(double value) {
  std::ostringstream text;
  text.precision(3);
  text << value;
  return text.str();
}

} // namespace burnish
