#include "friction_choice.hpp"
#include "base/error.hpp"
#include "contact/formula_friction.hpp"

namespace rigidcontact {

using Law = std::shared_ptr<const burnish::FrictionLaw>;

Law friction_choice(const Named& a, const Law& otherwise, const std::map<std::string, double>& parameters) {
  const char* where = "contact.add";
  const bool sticking = a.boolean("sticking", false);
  if (a.has("friction") + a.has("tresca") + sticking + a.has("frictionlaw") > 1)
    burnish::fail(where, "give at most one of friction= (with shearlimit= if there is one), tresca=, "
                         "sticking=true and frictionlaw=");
  if (a.has("shearlimit") && !a.has("friction"))
    burnish::fail(where, "shearlimit= limits Coulomb friction: give friction= with it");
  if (sticking) return std::make_shared<burnish::StickingFriction>();
  return called(where, [&]() -> Law {
    if (a.has("frictionlaw")) return burnish::make_formula_friction(a.text("frictionlaw", ""), parameters);
    if (a.has("tresca")) return burnish::make_tresca(a.real("tresca", 0));
    if (a.has("shearlimit"))
      return burnish::make_limited_coulomb(a.real("friction", 0), a.real("shearlimit", 0));
    return a.has("friction") ? burnish::make_coulomb(a.real("friction", 0)) : otherwise;
  });
}

} // namespace rigidcontact
