#include "formula/formula_calls.hpp"
#include <stdexcept>

namespace burnish {
namespace {

constexpr std::size_t NO_WORD = static_cast<std::size_t>(-1);

/// An open parenthesis: with the function's name before it, or without.
FormulaCall opened(const std::vector<FormulaToken>& tokens, std::size_t open) {
  const bool called = open > 0 && tokens[open - 1].kind == FormulaToken::Kind::WORD;
  return {called ? open - 1 : NO_WORD, 1};
}

void compare(const std::vector<FormulaToken>& tokens, std::size_t i, std::vector<FormulaCall>& open) {
  const std::string sign = "\"" + tokens[i].text + "\"";
  const bool chosen = !open.empty() && open.back().word != NO_WORD && tokens[open.back().word].text == "if";
  if (!chosen || open.back().arguments > 1)
    wrong_formula(tokens[i].start, sign + " compares only as the first argument of if, as in if(x " +
                                       tokens[i].text + " y, a, b), without parentheses around it");
  if (open.back().comparison)
    wrong_formula(tokens[i].start, sign +
                                       " is the second comparison in one argument, expected one; another if "
                                       "in place of a or b takes the next");
  open.back().comparison = i;
}

} // namespace

std::vector<FormulaCall> formula_calls(const std::vector<FormulaToken>& tokens) {
  using Kind = FormulaToken::Kind;
  std::vector<FormulaCall> open, closed;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].kind == Kind::OPEN) open.push_back(opened(tokens, i));
    if (tokens[i].kind == Kind::COMPARISON) compare(tokens, i, open);
    if (open.empty()) continue; // a ")" or "," too many is the parser's matter
    if (tokens[i].kind == Kind::COMMA) ++open.back().arguments;
    if (tokens[i].kind != Kind::CLOSE) continue;
    if (open.back().word != NO_WORD) closed.push_back(open.back());
    open.pop_back();
  }
  for (const FormulaCall& call : open)
    if (call.comparison) throw std::invalid_argument("the formula ends too early, a \")\" is missing");
  return closed;
}

} // namespace burnish
