#pragma once
// Calls of functions in a formula's tokens.
#include "formula/formula_tokens.hpp"

namespace burnish {

/// name(argument, ...): where it is among the tokens.
struct FormulaCall {
  std::size_t word;           ///< its name
  int arguments;              ///< how many
  std::size_t comparison = 0; ///< the sign that compares in its first argument, 0: none
};

/// Calls whose parentheses are closed, in the order in which they are.
/// @throws std::invalid_argument with the place for a comparison that is not in the first argument of an if, and for a
/// second one there; for one in a call that is not closed
std::vector<FormulaCall> formula_calls(const std::vector<FormulaToken>& tokens);

} // namespace burnish
