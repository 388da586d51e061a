#pragma once
// All kinds of friction laws that a script can name.
#include "contact/friction_kind.hpp"

namespace burnish {

/// The table. A new law: its own source file, and one line here.
const std::vector<FrictionKind>& friction_kinds();

/// Parameters of all kinds.
std::vector<Parameter> friction_parameters();

/// The law that the arguments name, or `otherwise` if they name none.
/// @param constants for formulas
/// @throws std::invalid_argument "friction: ..." for several kinds, a parameter without the one that chooses its kind,
///         a number out of range, a wrong formula (quotes it)
std::shared_ptr<const FrictionLaw> make_friction(const Arguments& arguments,
                                                 const std::shared_ptr<const FrictionLaw>& otherwise,
                                                 const Constants& constants);

/// Every kind with its parameters, a line each.
std::string friction_help();

} // namespace burnish
