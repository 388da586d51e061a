#include "material/hardening.hpp"
#include "base/error.hpp"
#include <cmath>

namespace burnish {
namespace {

// --- the laws, and their table: here is where a new one goes -----------------------------------------

/// sigma_y = sigY + H ep.
class LinearHardening final : public HardeningLaw {
public:
  LinearHardening(double yield_stress, double hardening_modulus)
      : HardeningLaw({yield_stress, hardening_modulus}), m_yield_stress(yield_stress),
        m_hardening_modulus(hardening_modulus) {}

private:
  YieldStress evaluate(double plastic_strain_eq) const override {
    return {m_yield_stress + m_hardening_modulus * plastic_strain_eq, m_hardening_modulus};
  }
  double m_yield_stress, m_hardening_modulus;
};

const std::vector<HardeningEntry>& table() {
  static const std::vector<HardeningEntry> entries = {
      {"linear",
       "sigY + H*ep",
       {{"sigY", "initial yield stress", "stress", positive, "finite > 0"},
        {"H", "hardening modulus, 0: perfect plasticity", "stress", not_negative, "finite >= 0"}},
       [](const std::vector<double>& p) -> std::shared_ptr<const HardeningLaw> {
         return std::make_shared<LinearHardening>(p[0], p[1]);
       }},
  };
  return entries;
}

// --- what is the same for all -------------------------------------------------------------------------

} // namespace

// The root of q - stiffness x - sigma_y(ep + x), which falls from >= 0 at 0 to < 0 at q/stiffness.
double local_solve(const HardeningLaw& hardening, double plastic_strain_eq, double q, double stiffness,
                   double start) {
  constexpr int MAX_PASSES = 100;          // bisection alone would need some 50
  constexpr double RELATIVE_ERROR = 1e-15; // of q: rounding
  double low = 0, high = q / stiffness, x = start;
  for (int k = 0; k < MAX_PASSES; ++k) {
    if (!(x > low && x < high)) x = 0.5 * (low + high);
    const YieldStress yield = hardening.at(plastic_strain_eq + x);
    const double excess = q - stiffness * x - yield.value;
    if (std::abs(excess) <= RELATIVE_ERROR * q) break;
    (excess > 0 ? low : high) = x;
    const double next = x + excess / (stiffness + yield.slope);
    if (next == x) break;
    x = next;
  }
  return x;
}

const std::vector<HardeningEntry>& hardening_laws() { return table(); }

std::shared_ptr<const HardeningLaw> make_hardening(const std::string& name, const LawNumbers& numbers,
                                                   const char* where) {
  std::string known;
  for (const HardeningEntry& entry : table()) {
    known += (known.empty() ? "" : ", ") + std::string(entry.name);
    if (entry.name != name) continue;
    std::vector<double> values;
    for (const LawParameter& parameter : entry.parameters)
      values.push_back(number_of(numbers, parameter, where));
    return entry.make(values);
  }
  fail(where, "unknown hardening \"" + name + "\", expected one of " + known);
}

std::shared_ptr<const HardeningLaw> linear_hardening(double yield_stress, double hardening_modulus,
                                                     const char* where) {
  return make_hardening("linear", {{"sigY", yield_stress}, {"H", hardening_modulus}}, where);
}

} // namespace burnish
