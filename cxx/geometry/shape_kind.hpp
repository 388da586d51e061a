#pragma once
// How a kind of tool profile or surface is chosen by name and made from named values.
#include "base/arguments.hpp"
#include "geometry/profile.hpp"
#include "geometry/surface.hpp"
#include <functional>
#include <memory>

namespace burnish {

/// One kind, for the tables in shapes.cpp.
template <class Shape> struct KindOf {
  std::string example;               ///< "circle=R"
  std::vector<Parameter> parameters; ///< the first one chooses this kind
  /// @throws std::invalid_argument for values that make no such shape
  std::function<std::shared_ptr<const Shape>(const Arguments&)> make;
  std::string remark = {};    ///< after "takes no ...=", what to do instead
  bool takes_profile = false; ///< the words of a profile belong to it as well
};
using ShapeKind = KindOf<Profile<2>>;
using SurfaceKind = KindOf<Surface<3>>;

} // namespace burnish
