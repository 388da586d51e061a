#pragma once
// A formula's text cut into tokens.
#include <ginac/ginac.h>
#include <string>
#include <vector>

namespace burnish {

struct FormulaToken {
  enum class Kind { NUMBER, WORD, OPERATOR, OPEN, CLOSE, COMMA, COMPARISON };
  Kind kind;
  std::string text;
  std::size_t start; ///< in the formula, from 0
};

/// Tokens of the text, without blanks.
/// @throws std::invalid_argument with the place for a character that means nothing, for more than 100
/// parentheses within one another, and for a text of more than 10000 characters
std::vector<FormulaToken> formula_tokens(const std::string& text);

/// Exact value of a NUMBER (0.05: 1/20). @throws std::invalid_argument with the place for one beyond the
/// range of double
GiNaC::numeric token_number(const FormulaToken& token);

/// True for a letter followed by letters, digits and _.
bool is_identifier(const std::string& text);

/// Throws std::invalid_argument "at character <start + 1>: why".
[[noreturn]] void wrong_formula(std::size_t start, const std::string& why);

} // namespace burnish
