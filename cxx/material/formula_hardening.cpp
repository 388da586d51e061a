#include "material/formula_hardening.hpp"
#include "base/error.hpp"
#include "formula/formula.hpp"
#include <limits>

namespace burnish {
namespace {

class FormulaHardening final : public HardeningLaw {
public:
  FormulaHardening(const std::string& what, const std::string& text)
      : m_value(what, text, {{"ep"}, {}}), m_slope(m_value.derivative(0)) {
    const double nothing = 0;
    m_start.value = m_value(&nothing);
    try {
      m_start.slope = m_slope(&nothing);
    } catch (const FormulaDomainError&) {
      m_chord = STEEP_START;
      m_start.slope = (m_value(&STEEP_START) - m_start.value) / STEEP_START;
    }
  }
  /// @throws FormulaDomainError quoting the formula where it has no finite value, or no finite slope beyond the start
  YieldStress checked(double plastic_strain_eq) const {
    if (plastic_strain_eq < m_chord)
      return {m_start.value + m_start.slope * plastic_strain_eq, m_start.slope};
    return {m_value(&plastic_strain_eq), m_slope(&plastic_strain_eq)};
  }

private:
  YieldStress evaluate(double plastic_strain_eq) const override {
    constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
    if (!(plastic_strain_eq >= 0)) return {NOT_A_NUMBER, NOT_A_NUMBER};
    try {
      const YieldStress yield = checked(plastic_strain_eq);
      if (yield.value > 0) return yield;
    } catch (const FormulaDomainError&) {
    }
    return {NOT_A_NUMBER, NOT_A_NUMBER};
  }
  Formula m_value, m_slope;
  YieldStress m_start; // of ep = 0
  double m_chord = 0;  // where its straight line ends, 0: there is none
};

} // namespace

std::shared_ptr<const HardeningLaw> formula_hardening(const std::string& text, bool softening,
                                                      const char* where) {
  const auto law = std::make_shared<FormulaHardening>(std::string(where) + ": hardening", text);
  const YieldStress start = law->checked(0); // its own message for a pole at the start
  require(start.value > 0, where, "yield stress at ep = 0", start.value, "finite > 0");
  require_admissible(*law, softening, where);
  return law;
}

} // namespace burnish
