#include "material/hardening.hpp"
#include "base/error.hpp"
#include <cmath>
#include <limits>

namespace burnish {
namespace {

// --- the laws, and their table: here is where a new one goes -----------------------------------------

constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();

bool finite(double value) { return std::isfinite(value); }

/// sigma_y = sigY + H ep, H >= 0.
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

/// The same with H < 0, as long as it is positive. No straight line to at(), whose closed form would go on below 0.
class LinearSoftening final : public HardeningLaw {
public:
  LinearSoftening(double yield_stress, double hardening_modulus)
      : m_yield_stress(yield_stress), m_hardening_modulus(hardening_modulus) {}

private:
  YieldStress evaluate(double plastic_strain_eq) const override {
    const double value = m_yield_stress + m_hardening_modulus * plastic_strain_eq;
    return {value > 0 ? value : NOT_A_NUMBER, m_hardening_modulus};
  }
  double m_yield_stress, m_hardening_modulus;
};

const std::vector<HardeningEntry>& table() {
  static const std::vector<HardeningEntry> entries = {
      {"linear",
       "sigY + H*ep",
       {{"sigY", "initial yield stress", "stress", positive, "finite > 0"},
        {"H", "hardening modulus, 0: perfect plasticity, < 0: softening", "stress", finite, "finite"}},
       [](const std::vector<double>& p) -> std::shared_ptr<const HardeningLaw> {
         if (p[1] < 0) return std::make_shared<LinearSoftening>(p[0], p[1]);
         return std::make_shared<LinearHardening>(p[0], p[1]);
       }},
      {"perfect",
       "sigY",
       {{"sigY", "yield stress", "stress", positive, "finite > 0"}},
       [](const std::vector<double>& p) -> std::shared_ptr<const HardeningLaw> {
         return std::make_shared<LinearHardening>(p[0], 0);
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
    if (!(stiffness + yield.slope > 0)) return NOT_A_NUMBER;
    const double excess = q - stiffness * x - yield.value;
    if (!std::isfinite(excess)) return NOT_A_NUMBER;
    if (std::abs(excess) <= RELATIVE_ERROR * q) break;
    (excess > 0 ? low : high) = x;
    const double next = x + excess / (stiffness + yield.slope);
    if (next == x) break;
    x = next;
  }
  return x;
}

const std::vector<HardeningEntry>& hardening_laws() { return table(); }

std::string hardening_names() {
  std::string names;
  for (const HardeningEntry& entry : table()) names += (names.empty() ? "" : ", ") + std::string(entry.name);
  return names;
}

void require_admissible(const HardeningLaw& law, bool softening, const char* where) {
  constexpr int SAMPLES = 1000;
  const auto wrong = [&](const char* what, double value, double plastic_strain_eq, const char* expected) {
    std::ostringstream text;
    text << what << " = " << value << " at ep = " << plastic_strain_eq << ", expected " << expected;
    fail(where, text.str());
  };
  bool falls = false;
  for (int k = 0; k <= SAMPLES; ++k) {
    const double plastic_strain_eq = k * SAMPLED_STRAIN / SAMPLES;
    const YieldStress yield = law.at(plastic_strain_eq);
    if (!(yield.value > 0 && finite(yield.value)) && !falls)
      wrong("yield stress", yield.value, plastic_strain_eq, "finite > 0");
    if (!finite(yield.value)) return;
    if (!finite(yield.slope)) wrong("slope of the yield stress", yield.slope, plastic_strain_eq, "finite");
    falls = falls || yield.slope < 0;
    if (falls && !softening)
      wrong("slope of the yield stress", yield.slope, plastic_strain_eq,
            ">= 0: with softening the problem is no longer well-posed and the result depends on the mesh; "
            "softening=true runs it all the same");
  }
}

std::shared_ptr<const HardeningLaw> make_hardening(const std::string& name, const LawNumbers& numbers,
                                                   const char* where, bool softening) {
  for (const HardeningEntry& entry : table()) {
    if (entry.name != name) continue;
    std::vector<double> values;
    for (const LawParameter& parameter : entry.parameters)
      values.push_back(number_of(numbers, parameter, where));
    std::shared_ptr<const HardeningLaw> law = entry.make(values);
    require_admissible(*law, softening, where);
    return law;
  }
  fail(where, "unknown hardening \"" + name + "\", expected one of " + hardening_names());
}

std::shared_ptr<const HardeningLaw> linear_hardening(double yield_stress, double hardening_modulus,
                                                     const char* where, bool softening) {
  return make_hardening("linear", {{"sigY", yield_stress}, {"H", hardening_modulus}}, where, softening);
}

} // namespace burnish
