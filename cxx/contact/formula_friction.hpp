#pragma once
// User-defined friction law: traction as a formula of pressure.
#include "contact/friction.hpp"
#include "formula/formula.hpp"

namespace burnish {

/// g = A t(p), p = N/A, slope t'(p), differentiated exactly. For N < 0 the law goes on linearly from p = 0,
/// g = A t(0) + t'(0) N: an iteration may pass there.
class FormulaFriction final : public FrictionLaw {
public:
  /// @param traction   formula of t in the variable p, both [stress]; it must be finite and >= 0 at every
  ///                   p >= 0 met, and have a finite slope at p = 0
  /// @param parameters numbers by name
  /// @throws std::invalid_argument for a wrong formula (see Formula), a parameter that is called p, and for
  /// t(0) < 0 or t(0), t'(0) not finite (quotes the formula)
  explicit FormulaFriction(const std::string& traction, const std::map<std::string, double>& parameters = {});
  /// @throws FormulaDomainError quoting the formula, p and the value where t < 0 or not finite
  double limit(double N, double area) const override;
  double slope(double N, double area) const override;
  const std::string& text() const { return m_traction.text(); }
  /// True if t = 0 for every p.
  bool vanishes() const;

private:
  Formula m_traction, m_derivative;
  double m_t0 = 0, m_slope0 = 0; // at p = 0
};

FrictionKind formula_kind(); ///< frictionlaw=, for the table in friction_laws.hpp

/// NoFriction for a formula that is 0 for every p, else FormulaFriction.
std::shared_ptr<const FrictionLaw>
make_formula_friction(const std::string& traction, const std::map<std::string, double>& parameters = {});

} // namespace burnish
