#pragma once
// A user's formula as text: parsed and differentiated exactly by GiNaC, evaluated in double precision.
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace burnish {

/// A place where a formula has no value. The formula itself is in order: a smaller step may stay clear of
/// it.
class FormulaDomainError : public std::invalid_argument {
public:
  using std::invalid_argument::invalid_argument;
};

/// Names of variables, in the order of the values, and numbers for names that stay constant.
struct FormulaNames {
  std::vector<std::string> variables;
  std::map<std::string, double> parameters;
};

/// Names of GiNaC's own functions that formulas cannot call (beta, zeta, psi, S, H ...) are free.
/// @throws std::invalid_argument "where: ..." for a variable or parameter whose name is no identifier, has
/// more than 100 characters, occurs twice, or is a constant of GiNaC or a function that formulas may call,
/// and for a parameter that is not finite or below 2.3e-308
void check_formula_names(const std::string& where, const FormulaNames& names);

/// The text in quotes for a message, only its beginning if it is very long.
std::string quoted(const std::string& text);

/// Immutable; copies share the parsed expression. pi is known as pi and Pi; functions are sin cos tan asin
/// acos atan atan2 sinh cosh tanh asinh acosh atanh exp log sqrt pow abs step (0, at zero 1/2, 1), sign
/// (-1, 0, 1), min(a, b), max(a, b) and if(c, a, b): a where c > 0, else b; c may compare, x > y, <, >=, <=.
/// What if does not take need not have a value. Powers are ^. A sign after an operator needs parentheses:
/// x^(-2). Parameters are put in as numbers. atan2(0, 0) is 0. A formula has at most 10000 characters and 100
/// parentheses within one another, a derivative at most a million numbers, names and operations. One
/// evaluation costs some 0.1 microseconds.
class Formula {
public:
  /// @param what  how messages call it, for example: x of tool "crank"
  /// @throws std::invalid_argument `what "text": ...` with the place in the text for wrong syntax and for a
  /// name that is neither variable, parameter nor function (lists the names known); for names that are no
  /// identifiers, occur twice, or are taken by functions or constants (pi, Pi, I, Euler, Catalan); for
  /// parameters that are not finite; for constant parts without a finite real value (1/0, sqrt(-1)), too
  /// small for double (1e-400) or too large to be computed exactly (2^(10^9)), and for a text that is too
  /// long
  Formula(std::string what, std::string text, const FormulaNames& names);
  /// Value at the variables' values, one per variable.
  /// @throws FormulaDomainError quoting formula and place ("beta = 1.5708") where the value, or one on the
  /// way to it, is not a finite real number (pole, root or logarithm of a negative number)
  double operator()(const double* values) const;
  /// Exact derivative by a variable, nothing is smoothed. step and sign count as flat everywhere, abs has none
  /// at zero; that of min and max where both are equal is the one on the side where the variable grows; that of
  /// if is the one of the branch that is taken, and a jump from one to the other has none.
  /// @throws std::invalid_argument if the variable is out of range, if the formula is too long to be
  /// differentiated, or if a constant part of the derivative is no finite real number
  Formula derivative(int variable) const;
  /// False if the value does not change with the variable, not by a jump either. (True if it would take more
  /// than 1000 terms to see.)
  bool depends_on(int variable) const;
  const std::string& text() const; ///< as given; that of the original for a derivative

private:
  struct Source;
  struct Impl;
  std::shared_ptr<const Impl> m_impl;
};

} // namespace burnish
