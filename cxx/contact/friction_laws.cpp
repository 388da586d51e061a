#include "contact/friction_laws.hpp"
#include "base/error.hpp"
#include "contact/formula_friction.hpp"
#include <algorithm>

namespace burnish {
namespace {

bool chosen(const FrictionKind& kind, const Arguments& arguments) {
  const Parameter& first = kind.parameters[0];
  return first.kind == ArgumentKind::FLAG ? arguments.flag(first.name) : arguments.has(first.name);
}

std::string examples() {
  std::string text;
  const auto& kinds = friction_kinds();
  for (std::size_t i = 0; i < kinds.size(); ++i)
    text += (i == 0 ? "" : i + 1 < kinds.size() ? ", " : " and ") + kinds[i].example;
  return text;
}

} // namespace

const std::vector<FrictionKind>& friction_kinds() {
  static const std::vector<FrictionKind> kinds{coulomb_kind(), tresca_kind(), sticking_kind(),
                                               formula_kind()};
  return kinds;
}

std::vector<Parameter> friction_parameters() {
  std::vector<Parameter> list;
  for (const FrictionKind& kind : friction_kinds())
    list.insert(list.end(), kind.parameters.begin(), kind.parameters.end());
  return list;
}

std::shared_ptr<const FrictionLaw> make_friction(const Arguments& arguments,
                                                 const std::shared_ptr<const FrictionLaw>& otherwise,
                                                 const Constants& constants) {
  const FrictionKind* law = nullptr;
  for (const FrictionKind& kind : friction_kinds()) {
    if (!chosen(kind, arguments)) continue;
    if (law) fail("friction", "give at most one of " + examples());
    law = &kind;
  }
  for (const FrictionKind& kind : friction_kinds())
    for (const Parameter& parameter : kind.parameters)
      if (&kind != law && parameter.kind != ArgumentKind::FLAG && arguments.has(parameter.name))
        fail("friction", kind.remark);
  return law ? law->make(arguments, constants) : otherwise;
}

std::string friction_help() {
  std::string text;
  for (const FrictionKind& kind : friction_kinds())
    for (const Parameter& parameter : kind.parameters) {
      std::string left = (&parameter == &kind.parameters[0] ? "" : "    ") + parameter.name + "=";
      left.resize(std::max<std::size_t>(left.size() + 2, 20), ' ');
      text += left + parameter.help + "\n";
    }
  return text;
}

} // namespace burnish
