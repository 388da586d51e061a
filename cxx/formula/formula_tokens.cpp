#include "formula/formula_tokens.hpp"
#include <cmath>
#include <stdexcept>

namespace burnish {
namespace {

constexpr std::size_t LONGEST = 10000; ///< characters of a formula
constexpr int DEEPEST = 100;           ///< parentheses within one another

using Kind = FormulaToken::Kind;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Length of the digits from `at` on.
std::size_t digits(const std::string& text, std::size_t at) {
  std::size_t end = at;
  while (end < text.size() && is_digit(text[end])) ++end;
  return end - at;
}

/// Length of the number that begins at `at`, 0 if there is none: digits with a point, perhaps an exponent.
std::size_t number_length(const std::string& text, std::size_t at) {
  std::size_t count = digits(text, at), end = at + count;
  if (end < text.size() && text[end] == '.') {
    const std::size_t decimals = digits(text, end + 1);
    count += decimals;
    end += 1 + decimals;
  }
  if (count == 0) return 0;
  if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
    const bool sign = end + 1 < text.size() && (text[end + 1] == '+' || text[end + 1] == '-');
    const std::size_t first = end + 1 + sign, length = digits(text, first);
    if (length > 0) end = first + length;
  }
  return end - at;
}

/// Length of the identifier that begins at `at`, 0 if there is none.
std::size_t word_length(const std::string& text, std::size_t at) {
  if (at >= text.size() || !is_letter(text[at])) return 0;
  std::size_t end = at + 1;
  while (end < text.size() && (is_letter(text[end]) || is_digit(text[end]) || text[end] == '_')) ++end;
  return end - at;
}

/// Length of the comparison that begins at `at`, < > <= >=, 0 if there is none.
std::size_t comparison_length(const std::string& text, std::size_t at) {
  if (text[at] != '<' && text[at] != '>') return 0;
  return at + 1 < text.size() && text[at + 1] == '=' ? 2 : 1;
}

/// The character at `at` for a message: quoted, all bytes of UTF-8; control characters by number.
std::string shown(const std::string& text, std::size_t at) {
  const auto code = static_cast<unsigned char>(text[at]);
  if (code < 32 || code == 127) return "the control character " + std::to_string(code);
  std::size_t end = at + 1;
  while (code >= 0xC0 && end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) ++end;
  return "\"" + text.substr(at, end - at) + "\"";
}

} // namespace

void wrong_formula(std::size_t start, const std::string& why) {
  throw std::invalid_argument("at character " + std::to_string(start + 1) + ": " + why);
}

std::vector<FormulaToken> formula_tokens(const std::string& text) {
  if (text.size() > LONGEST)
    throw std::invalid_argument("the formula has " + std::to_string(text.size()) +
                                " characters, expected at most " + std::to_string(LONGEST));
  static const std::string signs = "+-*/^(),", blanks = " \t\n\r\f\v";
  std::vector<FormulaToken> tokens;
  int depth = 0;
  for (std::size_t at = 0; at < text.size(); at += tokens.back().text.size()) {
    at = text.find_first_not_of(blanks, at);
    if (at == std::string::npos) break;
    if (const std::size_t length = number_length(text, at))
      tokens.push_back({Kind::NUMBER, text.substr(at, length), at});
    else if (const std::size_t letters = word_length(text, at))
      tokens.push_back({Kind::WORD, text.substr(at, letters), at});
    else if (const std::size_t both = comparison_length(text, at))
      tokens.push_back({Kind::COMPARISON, text.substr(at, both), at});
    else if (const auto kind = signs.find(text[at]); kind != std::string::npos)
      tokens.push_back({kind < 5 ? Kind::OPERATOR : static_cast<Kind>(kind - 2), text.substr(at, 1), at});
    else
      wrong_formula(at, shown(text, at) + " means nothing in a formula");
    depth += (text[at] == '(') - (text[at] == ')');
    if (depth > DEEPEST)
      wrong_formula(at, "more than " + std::to_string(DEEPEST) + " parentheses within one another");
  }
  return tokens;
}

GiNaC::numeric token_number(const FormulaToken& token) {
  const double value = std::strtod(token.text.c_str(), nullptr);
  if (!std::isfinite(value)) wrong_formula(token.start, "the number is too large");
  const std::size_t letter = token.text.find_first_of("eE");
  std::string digits = token.text.substr(0, letter);
  if (digits.find_first_not_of("0.") == std::string::npos) return 0;
  if (!std::isnormal(value)) wrong_formula(token.start, "the number is too small");
  long exponent = letter == std::string::npos ? 0 : std::stol(token.text.substr(letter + 1));
  if (const std::size_t point = digits.find('.'); point != std::string::npos) {
    exponent -= static_cast<long>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  digits.erase(0, digits.find_first_not_of('0'));
  return GiNaC::numeric(digits.c_str()) * GiNaC::pow(GiNaC::numeric(10), GiNaC::numeric(exponent));
}

bool is_identifier(const std::string& text) { return !text.empty() && word_length(text, 0) == text.size(); }

} // namespace burnish
