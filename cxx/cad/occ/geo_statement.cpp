#include "cad/occ/geo_statement.hpp"
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace burnish {

namespace {

/// A place in the text that goes on over what is expected.
class Cursor {
public:
  explicit Cursor(const std::string& text) : m_at(text.c_str()) {}
  bool is(char c) {
    skip_blanks();
    if (*m_at != c) return false;
    ++m_at;
    return true;
  }
  std::string word() {
    std::string word;
    skip_blanks();
    while (std::isalpha(static_cast<unsigned char>(*m_at))) word += *m_at++;
    return word;
  }
  bool number(double& value) {
    char* end = nullptr;
    value = std::strtod(m_at, &end);
    const bool found = end != m_at;
    m_at = end;
    return found;
  }
  /// {number, name or number, ...}: names count as 0 (mesh sizes of points).
  bool list(std::vector<double>& values) {
    if (!is('{')) return false;
    do {
      double value = 0;
      if (!number(value)) skip_name();
      values.push_back(value);
    } while (is(','));
    return is('}');
  }

private:
  void skip_blanks() {
    while (std::isspace(static_cast<unsigned char>(*m_at))) ++m_at;
  }
  void skip_name() {
    skip_blanks();
    while (std::isalnum(static_cast<unsigned char>(*m_at)) || *m_at == '_') ++m_at;
  }
  const char* m_at;
};

// A tag or an order; 0, which none has, where the number is not one.
int whole(double number) {
  constexpr double most = std::numeric_limits<int>::max();
  return std::abs(number) <= most ? static_cast<int>(number) : 0;
}

bool read(const std::string& text, GeoStatement& statement) {
  Cursor cursor(text);
  double tag = 0;
  statement.word = cursor.word();
  if (statement.word.empty() || !cursor.is('(') || !cursor.number(tag) || !cursor.is(')') || !cursor.is('='))
    return false;
  if (!cursor.list(statement.numbers)) return false;
  statement.tag = whole(tag);
  for (const double number : statement.numbers) statement.points.push_back(whole(number));
  double order = 0;
  if (cursor.word() == "Knots" && cursor.list(statement.knots) && cursor.word() == "Order" &&
      cursor.number(order))
    statement.order = whole(order);
  return true;
}

} // namespace

std::vector<GeoStatement> geo_statements(const std::string& text) {
  std::vector<GeoStatement> all;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(';', begin), text.size());
    GeoStatement statement;
    if (read(text.substr(begin, end - begin), statement)) all.push_back(statement);
    begin = end + 1;
  }
  return all;
}

} // namespace burnish
