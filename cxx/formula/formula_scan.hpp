#pragma once
// Reads the text of a formula: words, names and places are checked here, GiNaC's parser does the rest.
#include <ginac/ginac.h>
#include <string>

namespace burnish {

/// The simplest fraction that rounds to the value (0.1: 1/10): GiNaC then computes without rounding errors.
/// @throws an exception of CLN for numbers below 1e-307
GiNaC::numeric exact_number(double value);

/// Expression of the text; decimal numbers become exact fractions. Stricter than GiNaC: a sign after an
/// operator needs parentheses, x^(-2), because GiNaC's parser would take it for the sign of all that
/// follows.
/// @param table  expression of every name
/// @throws std::invalid_argument with the place in the text for wrong syntax, for an unknown name or
/// function (lists the names known), for constant parts that are not real (sqrt(-1)) or powers too large to
/// be computed exactly; GiNaC's own exceptions for a pole such as 1/0
GiNaC::ex parse_formula(const std::string& text, const GiNaC::symtab& table);

} // namespace burnish
