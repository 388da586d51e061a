#include "contact/friction.hpp"
#include "base/error.hpp"
#include "contact/friction_kind.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace burnish {
namespace {

void require_not_negative(const char* law, const char* name, double value) {
  require(std::isfinite(value) && value >= 0, law, name, value, (std::string(name) + " >= 0").c_str());
}

} // namespace

CoulombFriction::CoulombFriction(double mu) : m_mu(mu) { require_not_negative("CoulombFriction", "mu", mu); }

TrescaFriction::TrescaFriction(double k) : m_k(k) {
  require_not_negative("TrescaFriction", "tresca traction k", k);
}

LimitedCoulombFriction::LimitedCoulombFriction(double mu, double k) : m_mu(mu), m_k(k) {
  require_not_negative("LimitedCoulombFriction", "mu", mu);
  require_not_negative("LimitedCoulombFriction", "shear limit k", k);
}

double LimitedCoulombFriction::limit(double N, double area) const { return std::min(m_mu * N, area * m_k); }

double LimitedCoulombFriction::slope(double N, double area) const {
  return m_mu * N <= area * m_k ? m_mu : 0;
}

double StickingFriction::limit(double, double) const { return std::numeric_limits<double>::infinity(); }

FrictionKind coulomb_kind() {
  return {"friction= (with shearlimit= if there is one)",
          {{"friction", ArgumentKind::NUMBER, "Coulomb: largest traction friction*p"},
           {"shearlimit", ArgumentKind::NUMBER, "[stress] and no more than this shear strength"}},
          [](const Arguments& a, const Constants&) {
            const double mu = a.number("friction", 0);
            return a.has("shearlimit") ? make_limited_coulomb(mu, a.number("shearlimit", 0))
                                       : make_coulomb(mu);
          },
          "shearlimit= limits Coulomb friction: give friction= with it"};
}

FrictionKind tresca_kind() {
  return {"tresca=",
          {{"tresca", ArgumentKind::NUMBER, "[stress] shear traction under any pressure"}},
          [](const Arguments& a, const Constants&) { return make_tresca(a.number("tresca", 0)); }};
}

FrictionKind sticking_kind() {
  return {"sticking=true",
          {{"sticking", ArgumentKind::FLAG, "true: a node never slides"}},
          [](const Arguments&, const Constants&) { return std::make_shared<StickingFriction>(); }};
}

std::shared_ptr<const FrictionLaw> make_coulomb(double mu) {
  if (mu == 0) return std::make_shared<NoFriction>();
  return std::make_shared<CoulombFriction>(mu);
}

std::shared_ptr<const FrictionLaw> make_tresca(double k) {
  if (k == 0) return std::make_shared<NoFriction>();
  return std::make_shared<TrescaFriction>(k);
}

std::shared_ptr<const FrictionLaw> make_limited_coulomb(double mu, double k) {
  auto law = std::make_shared<LimitedCoulombFriction>(mu, k); // checks both
  if (mu == 0 || k == 0) return std::make_shared<NoFriction>();
  return law;
}

} // namespace burnish
