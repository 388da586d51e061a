#pragma once
// Kinematic hardening: the yield surface moves by a back stress X, METHOD.md (1.24).
#include "material/law_parameter.hpp"

namespace burnish {

/// Rate of X in the frame of the law's rate: 2/3 C d eps_p - gamma X d ep. gamma = 0 is [Prager1956], else
/// [ArmstrongFrederick1966], where q(X) tends to C/gamma.
struct KinematicHardening {
  double modulus = 0;  ///< C >= 0 [stress]; 0: no back stress
  double recovery = 0; ///< gamma >= 0 [-]
  bool exists() const { return modulus > 0; }
};

/// One line of the table of laws of the back stress.
struct BackstressEntry {
  const char* name;    ///< as a script gives it
  const char* formula; ///< rate of X in the names of its parameters
  std::vector<LawParameter> parameters;
};
const std::vector<BackstressEntry>& backstress_laws();
/// The entry of that name. @throws std::invalid_argument "where: ..." if there is none (lists the table)
const BackstressEntry& backstress_law(const std::string& name, const char* where);

/// From the numbers of an entry. @throws std::invalid_argument "where: ..." if one is missing or out of its range
KinematicHardening make_kinematic_hardening(const BackstressEntry& entry, const LawNumbers& numbers,
                                            const char* where);

} // namespace burnish
