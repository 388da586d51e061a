#include "material/j2.hpp"
#include "base/error.hpp"
#include <cmath>

namespace burnish {

void require_valid(const J2Parameters& material, const char* where) {
  const auto positive = [](double x) { return x > 0 && std::isfinite(x); };
  require(positive(material.K), where, "K", material.K, "finite > 0");
  require(positive(material.G), where, "G", material.G, "finite > 0");
  require(positive(material.yield_stress), where, "yield_stress", material.yield_stress, "finite > 0");
  const double H = material.hardening_modulus;
  require(H >= 0 && std::isfinite(H), where, "hardening_modulus", H, "finite >= 0");
}

namespace {
J2Parameters from_shear_checked(const char* where, double G, double nu, double yield_stress,
                                double hardening_modulus) {
  require(nu > -1 && nu < 0.5, where, "nu", nu, "-1 < nu < 0.5");
  J2Parameters material;
  material.K = 2 * G * (1 + nu) / (3 * (1 - 2 * nu));
  material.G = G;
  material.yield_stress = yield_stress;
  material.hardening_modulus = hardening_modulus;
  require_valid(material, where);
  return material;
}
} // namespace

J2Parameters J2Parameters::from_shear(double G, double nu, double yield_stress, double hardening_modulus) {
  const char* where = "J2Parameters::from_shear";
  require(G > 0 && std::isfinite(G), where, "G", G, "finite > 0");
  return from_shear_checked(where, G, nu, yield_stress, hardening_modulus);
}

J2Parameters J2Parameters::from_young(double E, double nu, double yield_stress, double hardening_modulus) {
  const char* where = "J2Parameters::from_young";
  require(E > 0 && std::isfinite(E), where, "E", E, "finite > 0");
  return from_shear_checked(where, E / (2 * (1 + nu)), nu, yield_stress, hardening_modulus);
}

} // namespace burnish
