#include "friction_choice.hpp"
#include "base/error.hpp"
#include "contact/formula_friction.hpp"

namespace burnish {

using Law = std::shared_ptr<const FrictionLaw>;

Law friction_choice(const Named& a, const Law& otherwise, const std::map<std::string, double>& parameters) {
  const char* where = "contact.add";
  const bool sticking = a.boolean("sticking", false);
  if (a.has("friction") + a.has("tresca") + sticking + a.has("frictionlaw") > 1)
    fail(where, "give at most one of friction= (with shearlimit= if there is one), tresca=, "
                "sticking=true and frictionlaw=");
  if (a.has("shearlimit") && !a.has("friction"))
    fail(where, "shearlimit= limits Coulomb friction: give friction= with it");
  if (sticking) return std::make_shared<StickingFriction>();
  return called(where, [&]() -> Law {
    if (a.has("frictionlaw")) return make_formula_friction(a.text("frictionlaw", ""), parameters);
    if (a.has("tresca")) return make_tresca(a.real("tresca", 0));
    if (a.has("shearlimit")) return make_limited_coulomb(a.real("friction", 0), a.real("shearlimit", 0));
    return a.has("friction") ? make_coulomb(a.real("friction", 0)) : otherwise;
  });
}

} // namespace burnish
