#include "material/kinematic_hardening.hpp"
#include "base/error.hpp"

namespace burnish {
namespace {

const LawParameter MODULUS = {"C", "modulus of the back stress", "stress", positive, "finite > 0"};
const LawParameter RECOVERY = {"gamma", "recovery of the back stress", "-", not_negative, "finite >= 0"};

} // namespace

const std::vector<BackstressEntry>& backstress_laws() {
  static const std::vector<BackstressEntry> table = {
      {"none", "0", {}},
      {"prager", "2/3*C*deps_p", {MODULUS}},
      {"armstrongfrederick", "2/3*C*deps_p - gamma*X*dep", {MODULUS, RECOVERY}}};
  return table;
}

const BackstressEntry& backstress_law(const std::string& name, const char* where) {
  std::string known;
  for (const BackstressEntry& entry : backstress_laws()) {
    if (entry.name == name) return entry;
    known += (known.empty() ? "" : ", ") + std::string(entry.name);
  }
  fail(where, "unknown backstress \"" + name + "\", expected one of " + known);
}

KinematicHardening make_kinematic_hardening(const BackstressEntry& entry, const LawNumbers& numbers,
                                            const char* where) {
  KinematicHardening law;
  for (const LawParameter& parameter : entry.parameters)
    (parameter.name == std::string("C") ? law.modulus : law.recovery) = number_of(numbers, parameter, where);
  return law;
}

} // namespace burnish
