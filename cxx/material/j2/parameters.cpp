#include "material/j2/parameters.hpp"
#include "base/error.hpp"

namespace burnish {

void require_valid(const J2Parameters& material, const char* where) {
  require_valid(material.elastic, where);
  if (!material.hardening) fail(where, "there is no hardening law");
  const double slope = material.yield_stress(0).slope;
  require(slope > -3 * material.elastic.G, where, "slope of the yield stress at ep = 0", slope,
          "> -3G: below it there is no return to the yield surface");
  require(not_negative(material.kinematic.modulus), where, "C", material.kinematic.modulus, "finite >= 0");
  require(not_negative(material.kinematic.recovery), where, "gamma", material.kinematic.recovery,
          "finite >= 0");
}

J2Parameters J2Parameters::from_shear(double G, double nu, double yield_stress, double hardening_modulus) {
  const char* where = "J2Parameters::from_shear";
  return {ElasticModuli::from_shear(G, nu, where), linear_hardening(yield_stress, hardening_modulus, where)};
}

J2Parameters J2Parameters::from_young(double E, double nu, double yield_stress, double hardening_modulus) {
  const char* where = "J2Parameters::from_young";
  return {ElasticModuli::from_young(E, nu, where), linear_hardening(yield_stress, hardening_modulus, where)};
}

} // namespace burnish
