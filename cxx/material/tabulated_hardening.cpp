#include "material/tabulated_hardening.hpp"
#include "base/error.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {
namespace {

class TabulatedHardening final : public HardeningLaw {
public:
  TabulatedHardening(std::vector<double> plastic_strain, std::vector<double> yield_stress)
      : m_plastic_strain(std::move(plastic_strain)), m_yield_stress(std::move(yield_stress)) {}

private:
  YieldStress evaluate(double plastic_strain_eq) const override {
    const auto above = std::upper_bound(m_plastic_strain.begin(), m_plastic_strain.end(), plastic_strain_eq);
    const std::size_t k = above - m_plastic_strain.begin();
    if (k == 0 || std::isnan(plastic_strain_eq)) return {std::nan(""), std::nan("")};
    if (k == m_plastic_strain.size()) return {m_yield_stress.back(), 0};
    const double slope =
        (m_yield_stress[k] - m_yield_stress[k - 1]) / (m_plastic_strain[k] - m_plastic_strain[k - 1]);
    return {m_yield_stress[k - 1] + slope * (plastic_strain_eq - m_plastic_strain[k - 1]), slope};
  }
  std::vector<double> m_plastic_strain, m_yield_stress;
};

std::string entry(const char* name, std::size_t k) {
  return std::string(name) + "[" + std::to_string(k) + "]";
}

} // namespace

std::shared_ptr<const HardeningLaw> tabulated_hardening(const std::vector<double>& plastic_strain,
                                                        const std::vector<double>& yield_stress,
                                                        bool softening, const char* where) {
  require(!plastic_strain.empty(), where, "entries of plasticstrain", plastic_strain.size(), "at least 1");
  require(yield_stress.size() == plastic_strain.size(), where, "entries of yieldstress", yield_stress.size(),
          ("as many as of plasticstrain, " + std::to_string(plastic_strain.size())).c_str());
  for (std::size_t k = 0; k < plastic_strain.size(); ++k) {
    const std::string strain = entry("plasticstrain", k), stress = entry("yieldstress", k);
    const bool follows = k == 0
                             ? plastic_strain[0] == 0
                             : plastic_strain[k] > plastic_strain[k - 1] && std::isfinite(plastic_strain[k]);
    require(follows, where, strain.c_str(), plastic_strain[k],
            k == 0 ? "0" : "finite and larger than the entry before");
    require(positive(yield_stress[k]), where, stress.c_str(), yield_stress[k], "finite > 0");
    require(
        softening || k == 0 || yield_stress[k] >= yield_stress[k - 1], where, stress.c_str(), yield_stress[k],
        ">= the entry before: with softening the problem is no longer well-posed and the result depends on "
        "the mesh; softening=true runs it all the same");
  }
  return std::make_shared<TabulatedHardening>(plastic_strain, yield_stress);
}

} // namespace burnish
