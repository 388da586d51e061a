#include "contact/formula_friction.hpp"
#include "base/error.hpp"
#include "contact/friction_kind.hpp"
#include <cmath>

namespace burnish {
namespace {

constexpr const char* WHAT = "friction law";

// Formula itself refuses values that are not finite, with formula and place.
double traction_at(const Formula& traction, double p) {
  const double t = traction(&p);
  if (t >= 0) return t;
  std::ostringstream text;
  text.precision(10);
  text << WHAT << " \"" << traction.text() << "\": " << t << " at p = " << p << ", expected a traction >= 0";
  throw FormulaDomainError(text.str());
}

} // namespace

FormulaFriction::FormulaFriction(const std::string& traction, const std::map<std::string, double>& parameters)
    : m_traction(WHAT, traction, {{"p"}, parameters}), m_derivative(m_traction.derivative(0)) {
  const double p = 0;
  m_t0 = traction_at(m_traction, p);
  m_slope0 = m_derivative(&p);
}

// A force that is not finite is the step loop's matter: it comes out as one, not as an error of the formula.
double FormulaFriction::limit(double N, double area) const {
  const bool inside = N >= 0 && std::isfinite(N);
  return inside ? area * traction_at(m_traction, N / area) : area * m_t0 + m_slope0 * N;
}

double FormulaFriction::slope(double N, double area) const {
  const double p = N / area;
  return N >= 0 && std::isfinite(N) ? m_derivative(&p) : m_slope0;
}

bool FormulaFriction::vanishes() const { return m_t0 == 0 && !m_traction.depends_on(0); }

FrictionKind formula_kind() {
  return {"frictionlaw=",
          {{"frictionlaw", ArgumentKind::TEXT, "traction as a formula of the pressure p, both [stress]"}},
          [](const Arguments& a, const Constants& constants) {
            return make_formula_friction(a.text("frictionlaw"), constants);
          }};
}

std::shared_ptr<const FrictionLaw> make_formula_friction(const std::string& traction,
                                                         const std::map<std::string, double>& parameters) {
  auto law = std::make_shared<FormulaFriction>(traction, parameters);
  if (law->vanishes()) return std::make_shared<NoFriction>();
  return law;
}

} // namespace burnish
