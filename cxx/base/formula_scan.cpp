#include "base/formula_scan.hpp"
#include "base/error.hpp"
#include "base/formula.hpp"
#include "base/formula_tape.hpp"
#include <algorithm>
#include <cln/cln.h>
#include <cmath>
#include <regex>
#include <set>
#include <sstream>

namespace burnish {
namespace {

constexpr long LONGEST = 1000; ///< decimal places of a number

enum class Kind { NUMBER, WORD, OPERATOR, OPEN, CLOSE, COMMA };
struct Token {
  Kind kind;
  std::string text;
  std::size_t start; ///< in the formula, from 0
};

[[noreturn]] void wrong(std::size_t start, const std::string& why) {
  throw std::invalid_argument("at character " + std::to_string(start + 1) + ": " + why);
}

std::vector<Token> tokens_of(const std::string& text) {
  static const std::regex number("([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][+-]?[0-9]+)?");
  static const std::regex word("[A-Za-z][A-Za-z0-9_]*");
  constexpr auto HERE = std::regex_constants::match_continuous;
  std::vector<Token> tokens;
  std::smatch match;
  for (auto at = text.begin(); at != text.end();) {
    const auto start = static_cast<std::size_t>(at - text.begin());
    if (std::isspace(static_cast<unsigned char>(*at))) {
      ++at;
      continue;
    }
    if (std::regex_search(at, text.end(), match, number, HERE))
      tokens.push_back({Kind::NUMBER, match.str(), start});
    else if (std::regex_search(at, text.end(), match, word, HERE))
      tokens.push_back({Kind::WORD, match.str(), start});
    else if (const auto kind = std::string("+-*/^(),").find(*at); kind != std::string::npos)
      tokens.push_back({kind < 5 ? Kind::OPERATOR : static_cast<Kind>(kind - 2), std::string(1, *at), start});
    else
      wrong(start, "\"" + std::string(1, *at) + "\" means nothing in a formula");
    at += static_cast<std::ptrdiff_t>(tokens.back().text.size());
  }
  return tokens;
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string known_names(const GiNaC::symtab& table) {
  std::vector<std::string> names;
  for (const auto& [name, expression] : table)
    if (name != "Pi") names.push_back(name);
  return listed(names);
}

/// Functions that a formula may call.
const std::vector<std::string>& functions() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list = FormulaTape::functions();
    list.insert(list.end(), {"sqrt", "pow"});
    return list;
  }();
  return names;
}

bool is_function(const std::string& name) {
  return std::count(functions().begin(), functions().end(), name) > 0;
}

void check_word(const std::vector<Token>& tokens, std::size_t i, const GiNaC::symtab& table) {
  const Token& token = tokens[i];
  const bool called = i + 1 < tokens.size() && tokens[i + 1].kind == Kind::OPEN;
  const bool known = table.count(token.text);
  if (called && known) wrong(token.start, "\"" + token.text + "\" is no function; a product needs *");
  if (called && !is_function(token.text))
    wrong(token.start, "unknown function \"" + token.text + "\", expected one of " + listed(functions()));
  if (called && i + 2 < tokens.size() && tokens[i + 2].kind == Kind::CLOSE)
    wrong(token.start, "function \"" + token.text + "\" has no argument");
  if (!called && !known && is_function(token.text))
    wrong(token.start, "function \"" + token.text + "\" needs its argument in parentheses");
  if (!called && !known)
    wrong(token.start, "unknown name \"" + token.text + "\", expected one of " + known_names(table));
}

/// What GiNaC would misread or report without a place.
void check_tokens(const std::vector<Token>& tokens, const GiNaC::symtab& table) {
  if (tokens.empty()) throw std::invalid_argument("the formula is empty");
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const Token& token = tokens[i];
    if (token.kind == Kind::WORD) check_word(tokens, i, table);
    if (i == 0) continue;
    const Kind before = tokens[i - 1].kind;
    const bool operand = token.kind == Kind::NUMBER || token.kind == Kind::WORD || token.kind == Kind::OPEN;
    if ((token.text == "-" || token.text == "+") && before == Kind::OPERATOR)
      wrong(token.start, "a sign after an operator needs parentheses, as in x*(-y)");
    if (operand && (before == Kind::NUMBER || before == Kind::CLOSE ||
                    (before == Kind::WORD && token.kind != Kind::OPEN)))
      wrong(token.start, "an operator is missing before \"" + token.text + "\"");
  }
}

/// 0.05 as (005*10^(-2)), for GiNaC would round it.
std::string exact_text(const Token& token) {
  if (token.kind != Kind::NUMBER) return token.text;
  if (!std::isfinite(std::strtod(token.text.c_str(), nullptr))) wrong(token.start, "the number is too large");
  const std::size_t letter = token.text.find_first_of("eE");
  std::string digits = token.text.substr(0, letter);
  long exponent = letter == std::string::npos ? 0 : std::stol(token.text.substr(letter + 1));
  if (const std::size_t point = digits.find('.'); point != std::string::npos) {
    exponent -= static_cast<long>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  if (exponent < -LONGEST) wrong(token.start, "the number is too small");
  return exponent == 0 ? digits : "(" + digits + "*10^(" + std::to_string(exponent) + "))";
}

/// What GiNaC reads, and where each token begins in it.
struct ExactText {
  std::string text;
  std::vector<std::size_t> starts;
  explicit ExactText(const std::vector<Token>& tokens) {
    for (const Token& token : tokens) {
      starts.push_back(text.size());
      text += exact_text(token) + " ";
    }
  }
};

/// GiNaC counts no columns. When it fails it has read its token and one character more.
std::string place_of_failure(std::istringstream& stream, const std::vector<Token>& tokens,
                             const ExactText& exact) {
  stream.clear();
  const auto read = static_cast<std::size_t>(stream.tellg());
  std::size_t last = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i)
    if (exact.starts[i] + 2 <= read) last = tokens[i].start;
  return "at character " + std::to_string(last + 1);
}

std::string syntax_message(const std::string& message, std::istringstream& stream,
                           const std::vector<Token>& tokens, const ExactText& exact) {
  if (message.find("power should have") != std::string::npos)
    return "a^b^c is ambiguous, write a^(b^c) or (a^b)^c";
  if (message.find("got: EOF") != std::string::npos)
    return std::string("the formula ends too early") +
           (message.find("')'") != std::string::npos ? ", a \")\" is missing" : "");
  const std::size_t start = message.find("column 0: ");
  std::string text = start == std::string::npos ? message : message.substr(start + 10);
  text = text.substr(0, text.find('\n'));
  return place_of_failure(stream, tokens, exact) + ": " + text;
}

} // namespace

void check_formula_names(const std::string& where, const FormulaNames& names) {
  static const std::set<std::string> constants{"I", "Pi", "pi", "Euler", "Catalan"};
  static const std::regex identifier("[A-Za-z][A-Za-z0-9_]*");
  std::set<std::string> known;
  const auto check = [&](const std::string& name) {
    if (!std::regex_match(name, identifier))
      fail(where, "name \"" + name + "\" is no identifier (a letter, then letters, digits and _)");
    if (is_function(name) || constants.count(name))
      fail(where, "name \"" + name + "\" is taken by a " + (is_function(name) ? "function" : "constant"));
    if (!known.insert(name).second) fail(where, "name \"" + name + "\" occurs twice");
  };
  for (const std::string& name : names.variables) check(name);
  for (const auto& [name, value] : names.parameters) {
    check(name);
    require(std::isfinite(value), where.c_str(), ("parameter \"" + name + "\"").c_str(), value,
            "a finite number");
  }
}

GiNaC::numeric exact_number(double value) { return GiNaC::numeric(cln::rationalize(cln::cl_R(value))); }

GiNaC::ex parse_formula(const std::string& text, const GiNaC::symtab& table) {
  const std::vector<Token> tokens = tokens_of(text);
  check_tokens(tokens, table);
  GiNaC::parser parser(table, true, GiNaC::get_default_reader());
  const ExactText exact(tokens);
  std::istringstream stream(exact.text);
  try {
    return parser(stream);
  } catch (const GiNaC::parse_error& error) {
    throw std::invalid_argument(syntax_message(error.what(), stream, tokens, exact));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(syntax_message(error.what(), stream, tokens, exact));
  }
}

} // namespace burnish
