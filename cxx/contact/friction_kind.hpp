#pragma once
// How a kind of friction law is chosen by name and made from named values.
#include "base/arguments.hpp"
#include "contact/friction.hpp"
#include <functional>

namespace burnish {

/// Numbers by name for formulas.
using Constants = std::map<std::string, double>;

/// One kind of law, for the table in friction_laws.cpp.
struct FrictionKind {
  std::string example;               ///< "tresca="
  std::vector<Parameter> parameters; ///< the first one chooses this kind; a flag does if it is true
  /// @throws std::invalid_argument for values that make no such law
  std::function<std::shared_ptr<const FrictionLaw>(const Arguments&, const Constants&)> make;
  std::string remark = {}; ///< error if another parameter is given without the first
};

} // namespace burnish
