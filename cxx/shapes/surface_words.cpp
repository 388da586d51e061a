// Words that several surfaces have: the axis, and the radius of edges, which without one have no normal.
#include "base/error.hpp"
#include "base/sentence.hpp"
#include "shapes/surface_kinds.hpp"
#include <cmath>

namespace burnish {
namespace {

using Make = std::function<std::shared_ptr<const Surface<3>>(double)>;

std::shared_ptr<const Surface<3>> tried(const Make& make, double fillet) {
  try {
    return make(fillet);
  } catch (const std::invalid_argument&) {
    return nullptr;
  }
}

// In six digits that fit when they are typed again; 0 if none does.
double largest(const Make& make, double most) {
  if (tried(make, most)) return most;
  double fits = 0, not_any_more = most;
  constexpr int halvings = 40;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (fits + not_any_more);
    (tried(make, middle) ? fits : not_any_more) = middle;
  }
  if (fits == 0) return 0;
  const double digit = std::pow(10, std::floor(std::log10(fits)) - 5);
  return std::floor(fits / digit + 1e-4) * digit;
}

} // namespace

std::shared_ptr<const Surface<3>> with_fillet(const char* where, const Arguments& given,
                                              const std::string& place, double most, const Make& make) {
  const double fillet = given.number("fillet", 0);
  if (fillet > 0 && std::isfinite(fillet))
    if (auto surface = tried(make, fillet)) return surface;
  const double fits = largest(make, most);
  if (fits == 0) {
    make(most);
    fail(where, "no fillet fits at " + place);
  }
  fail(where, sentence("the edge at ", place,
                       given.has("fillet") ? " cannot have the radius " : " is sharp: give it ",
                       "fillet = ", fillet, ", expected > 0 and up to ", fits));
}

Parameter axis_parameter() {
  return {"axis", ArgumentKind::NUMBERS, "direction of the axis in the tool's frame; z unless given"};
}

Parameter fillet_parameter() { return {"fillet", ArgumentKind::NUMBER, "radius of all edges [length]"}; }

AxisFrame axis_of(const char* where, const Arguments& given) {
  if (!given.has("axis")) return {};
  const std::vector<double> a = given.list("axis");
  require(a.size() == 3, where, "number of values in axis", a.size(), "3: [x,y,z]");
  return turned_frame(where, Vector<3>(a[0], a[1], a[2]));
}

} // namespace burnish
