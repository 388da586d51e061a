#pragma once
// A user's formula as text: parsed and differentiated exactly by GiNaC, evaluated in double precision.
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace burnish {

/// Names of variables, in the order of the values, and numbers for names that stay constant.
struct FormulaNames {
  std::vector<std::string> variables;
  std::map<std::string, double> parameters;
};

/// Immutable; copies share the parsed expression. pi is known as pi and Pi; functions are those of GiNaC
/// (sin cos tan asin acos atan atan2 sinh cosh tanh exp log sqrt abs step ...), powers are ^.
class Formula {
public:
  /// @param what  how messages call it, for example: x of tool "crank"
  /// @throws std::invalid_argument `what "text": ...` for wrong syntax (with the place in the text), for a name
  /// that is neither variable, parameter nor function (lists the names known), for names that are no
  /// identifiers, occur twice, or are GiNaC's own
  Formula(std::string what, std::string text, const FormulaNames& names);
  /// Value at the variables' values, one per variable.
  /// @throws std::invalid_argument quoting formula and place ("beta = 1.5708") where the value is not a finite
  /// real number (pole, root or logarithm of a negative number)
  double operator()(const double* values) const;
  /// Exact derivative by a variable. @throws std::invalid_argument if the variable is out of range
  Formula derivative(int variable) const;
  /// False if the value does not change with the variable.
  bool depends_on(int variable) const;
  const std::string& text() const;

private:
  struct Impl;
  std::shared_ptr<const Impl> m_impl;
};

} // namespace burnish
