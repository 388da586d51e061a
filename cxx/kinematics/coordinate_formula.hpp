#pragma once
// A number that depends on generalized coordinates by a formula: a driving force, or a coordinate that follows others.
#include "formula/formula.hpp"

namespace burnish {

/// What a formula is made of.
struct FormulaSource {
  std::string what, text; ///< how messages call it; its text
  FormulaNames names;     ///< variables in the order of the values, and numbers by name
  bool second = false;    ///< second derivatives are prepared, too
};

/// Formula with its exact derivatives by the variables that it depends on (METHOD.md 2.4, 2.6). Immutable.
class CoordinateFormula {
public:
  /// @param what   how messages call it, for example: force "y" of tool "roller"
  /// @param names  variables in the order of the values, and numbers by name
  /// @param second also prepares second derivatives
  /// @throws std::invalid_argument `what "text": ...` for everything that Formula refuses
  CoordinateFormula(const std::string& what, const std::string& text, const FormulaNames& names, bool second);
  /// The same of all of these. @throws std::invalid_argument as above
  explicit CoordinateFormula(const FormulaSource& source)
      : CoordinateFormula(source.what, source.text, source.names, source.second) {}

  const std::string& text() const { return m_value.text(); }
  const FormulaSource& source() const { return m_source; }
  /// Variables that the value depends on: indices into the values, ascending.
  const std::vector<int>& arguments() const { return m_arguments; }
  /// @param values one per variable
  /// @throws FormulaDomainError quoting formula and place where it has no finite real value
  double value(const double* values) const { return m_value(values); }
  /// Derivative by argument i; at a kink, as of abs at zero, the one on the side where the argument grows.
  /// @param size number of values
  /// @throws FormulaDomainError where it has none on that side either
  double first(std::size_t i, const double* values, std::size_t size) const;
  /// Second derivative by arguments i and j; only if prepared. Kinks as in first.
  double second(std::size_t i, std::size_t j, const double* values, std::size_t size) const;

private:
  double beside(const Formula& derivative, const double* values, std::size_t size) const;

  FormulaSource m_source;
  Formula m_value;
  std::vector<int> m_arguments;
  std::vector<Formula> m_first;               // [argument]
  std::vector<std::vector<Formula>> m_second; // [argument][argument up to it], or empty
};

/// A generalized force as a formula of the coordinates of its tool, of the tool's parameters and of t, the time at the end
/// of the step, unless a coordinate or a parameter is called t. Values: the coordinates in their order, then t.
/// @param tool, coordinate names, for messages; @param names of all coordinates of the tool
/// @throws std::invalid_argument naming tool and coordinate for everything that Formula refuses
std::shared_ptr<const CoordinateFormula> force_formula(const std::string& tool, const std::string& coordinate,
                                                       const std::string& text,
                                                       const std::vector<std::string>& names,
                                                       const std::map<std::string, double>& parameters);

/// A coordinate under motion as a formula of t, the time at the end of the step, and of the tool's parameters. Value: t.
/// @throws std::invalid_argument naming tool and coordinate for everything that Formula refuses, and for a parameter t
std::shared_ptr<const CoordinateFormula> motion_formula(const std::string& tool,
                                                        const std::string& coordinate,
                                                        const std::string& text,
                                                        const std::map<std::string, double>& parameters);

} // namespace burnish
