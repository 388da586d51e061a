#pragma once
// Isotropic hardening: the yield stress as a function of the accumulated plastic strain. The named laws and
// their table are in hardening.cpp; a new one touches that file only. By formula: formula_hardening.hpp, by
// numbers: tabulated_hardening.hpp.
#include "material/law_parameter.hpp"
#include <memory>

namespace burnish {

/// sigma_y(ep) and its derivative.
struct YieldStress {
  double value = 0; ///< > 0; not finite where the law has no value > 0 [stress]
  double slope = 0; ///< H' = d sigma_y/d ep [stress]
};

/// sigma_y(ep) of METHOD.md 1.7, Y there. Immutable.
class HardeningLaw {
public:
  virtual ~HardeningLaw() = default;
  /// @param plastic_strain_eq ep >= 0 [-]
  YieldStress at(double plastic_strain_eq) const {
    if (!m_linear) return evaluate(plastic_strain_eq);
    return {m_start.value + m_start.slope * plastic_strain_eq, m_start.slope};
  }
  /// Slope constant: returns have a closed form.
  bool is_linear() const { return m_linear; }

protected:
  HardeningLaw() = default;
  /// A law that is a straight line, by its value and slope at ep = 0: at() then calls nothing virtual in the
  /// innermost loop.
  explicit HardeningLaw(const YieldStress& start) : m_start(start), m_linear(true) {}

private:
  /// at() by the law's formula.
  virtual YieldStress evaluate(double plastic_strain_eq) const = 0;
  YieldStress m_start;
  bool m_linear = false;
};

/// Plastic increment x >= 0 of a return along a direction: q - stiffness x = sigma_y(ep + x) [-]: Newton's
/// method within a bracket, to rounding. Not finite where there is no return: the law has no value > 0, or
/// stiffness + H' is not > 0 on the way. @param start where it begins; the others as plastic_increment
double local_solve(const HardeningLaw& hardening, double plastic_strain_eq, double q, double stiffness,
                   double start);

/// The same in closed form where hardening is linear, (q - sigma_y)/(stiffness + H'), else by local_solve.
/// @param yield of ep; @param q >= yield.value: equivalent stress of the trial [stress]
/// @param stiffness > 0: what q loses per plastic strain, 3G for the radial return [stress]
inline double plastic_increment(const HardeningLaw& hardening, const YieldStress& yield,
                                double plastic_strain_eq, double q, double stiffness) {
  const double on_tangent = (q - yield.value) / (stiffness + yield.slope);
  if (hardening.is_linear()) return on_tangent;
  return local_solve(hardening, plastic_strain_eq, q, stiffness, on_tangent);
}

/// One line of the table of hardening laws.
struct HardeningEntry {
  const char* name;    ///< as a script gives it
  const char* formula; ///< sigma_y(ep) in the names of its parameters
  std::vector<LawParameter> parameters;
  std::shared_ptr<const HardeningLaw> (*make)(
      const std::vector<double>& values); ///< in the parameters' order
};
const std::vector<HardeningEntry>& hardening_laws();

/// The law of that name.
/// @param numbers all of its parameters; others may be there
/// @param softening whether the yield stress may fall
/// @throws std::invalid_argument "where: ..." if the name is unknown (lists the table), a parameter is
/// missing or out of its range, or see require_admissible
std::shared_ptr<const HardeningLaw> make_hardening(const std::string& name, const LawNumbers& numbers,
                                                   const char* where, bool softening = false);
/// Names of the table for messages: linear, perfect.
std::string hardening_names();

/// Samples a law on 0 <= ep <= SAMPLED_STRAIN.
/// @param softening true: the yield stress may fall, METHOD.md 1.7
/// @throws std::invalid_argument "where: ..." with ep and value where the slope is not finite, or is < 0 without
///         softening, and, but for a law that falls, where the yield stress is not finite and > 0
void require_admissible(const HardeningLaw& law, bool softening, const char* where);
inline constexpr double SAMPLED_STRAIN = 1;

/// sigma_y = yield_stress + hardening_modulus ep.
/// @throws std::invalid_argument "where: ..." unless yield_stress > 0, hardening_modulus >= 0 (any with softening),
///         both finite
std::shared_ptr<const HardeningLaw> linear_hardening(double yield_stress, double hardening_modulus,
                                                     const char* where = "linear_hardening",
                                                     bool softening = false);

} // namespace burnish
