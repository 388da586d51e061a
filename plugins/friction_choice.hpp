#pragma once
// The friction law that C.add(tool, ...) chooses by its named parameters.
#include "contact/friction.hpp"
#include "named.hpp"
#include <map>

namespace burnish {

/// Law of exactly one kind of named parameters, or `otherwise` if there is none of them:
///   friction=mu                   Coulomb: traction mu p
///   friction=mu, shearlimit=k     Coulomb limited by a shear strength: min(mu p, k)   [k: stress]
///   tresca=k                      shear traction k under any pressure                 [stress]
///   sticking=true                 never slides
///   frictionlaw="0.3*p/(1+p/k)"   traction as a formula of the pressure p, both [stress]
/// @param parameters numbers by name for the formula
/// @throws std::invalid_argument "contact.add: ..." for two kinds, a shear limit alone, a number out of
/// range, a wrong formula (quotes it)
std::shared_ptr<const FrictionLaw> friction_choice(const Named& a,
                                                   const std::shared_ptr<const FrictionLaw>& otherwise,
                                                   const std::map<std::string, double>& parameters);

} // namespace burnish
