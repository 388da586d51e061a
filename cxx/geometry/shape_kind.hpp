#pragma once
// How a kind of tool profile is chosen by name and made from named values.
#include "base/arguments.hpp"
#include "geometry/profile.hpp"
#include <functional>
#include <memory>

namespace burnish {

/// One kind of profile, for the table in shapes.cpp.
struct ShapeKind {
  std::string example;               ///< "circle=R"
  std::vector<Parameter> parameters; ///< the first one chooses this kind
  /// @throws std::invalid_argument for values that make no such profile
  std::function<std::shared_ptr<const Profile<2>>(const Arguments&)> make;
  std::string remark = {}; ///< after "takes no ...=", what to do instead
};

} // namespace burnish
