#include "contact/friction.hpp"
#include "base/error.hpp"
#include <cmath>

namespace burnish {

CoulombFriction::CoulombFriction(double mu) : m_mu(mu) {
  require(std::isfinite(mu) && mu >= 0, "CoulombFriction", "mu", mu, "mu >= 0");
}

std::shared_ptr<const FrictionLaw> make_coulomb(double mu) {
  if (mu == 0) return std::make_shared<NoFriction>();
  return std::make_shared<CoulombFriction>(mu);
}

} // namespace burnish
