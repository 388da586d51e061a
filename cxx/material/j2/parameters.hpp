#pragma once
// Parameters of J2 plasticity with isotropic and kinematic hardening (METHOD.md 1.4, 1.7, 1.11).
#include "material/elastic.hpp"
#include "material/hardening.hpp"
#include "material/kinematic_hardening.hpp"

namespace burnish {

struct J2Parameters {
  ElasticModuli elastic;
  std::shared_ptr<const HardeningLaw> hardening; ///< sigma_y(ep)
  KinematicHardening kinematic = {};             ///< of the back stress; none unless it exists()
  CorotationalRate rate = CorotationalRate::JAUMANN;

  /// sigma_y(ep).
  YieldStress yield_stress(double plastic_strain_eq) const { return hardening->at(plastic_strain_eq); }
  /// With linear hardening sigma_y = yield_stress + hardening_modulus ep.
  /// @throws std::invalid_argument naming this function, see ElasticModuli and linear_hardening
  static J2Parameters from_shear(double G, double nu, double yield_stress, double hardening_modulus);
  static J2Parameters from_young(double E, double nu, double yield_stress, double hardening_modulus);
};

/// @throws std::invalid_argument naming `where` if there is no hardening law, its slope at ep = 0 is not above -3G, C or
///         gamma of the back stress is not finite >= 0, or see ElasticModuli
void require_valid(const J2Parameters& material, const char* where);

} // namespace burnish
