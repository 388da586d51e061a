#include "geometry/simple_surfaces.hpp"
#include "base/error.hpp"
#include "geometry/circle.hpp"
#include "geometry/revolved.hpp"
#include "geometry/segment.hpp"
#include <cmath>

namespace burnish {
namespace {

constexpr const char* LENGTH = "a finite number > 0";

bool is_length(double value) { return std::isfinite(value) && value > 0; }

} // namespace

std::shared_ptr<const Surface<3>> sphere(double radius, const AxisFrame& axis, bool inside) {
  require(is_length(radius), "sphere", "radius", radius, LENGTH);
  return std::make_shared<Revolved>(std::make_shared<Circle>(radius, inside), axis);
}

std::shared_ptr<const Surface<3>> cylinder(double radius, double length, const AxisFrame& axis, bool inside) {
  require(is_length(radius), "cylinder", "radius", radius, LENGTH);
  require(is_length(length), "cylinder", "length", length, LENGTH);
  return cone(radius, radius, length, axis, inside);
}

std::shared_ptr<const Surface<3>> cone(double first_radius, double second_radius, double height,
                                       const AxisFrame& axis, bool inside) {
  require(std::isfinite(first_radius) && first_radius >= 0, "cone", "first radius", first_radius,
          "a finite number >= 0");
  require(std::isfinite(second_radius) && second_radius >= 0, "cone", "second radius", second_radius,
          "a finite number >= 0");
  require(first_radius + second_radius > 0, "cone", "second radius", second_radius, "> 0, or the first one");
  require(is_length(height), "cone", "height", height, LENGTH);
  Vector<2> begin(second_radius, height), end(first_radius, 0); // the body on the left: outside
  if (inside) std::swap(begin, end);
  return std::make_shared<Revolved>(std::make_shared<Segment>(begin, end), axis);
}

std::shared_ptr<const Surface<3>> torus(double ring, double tube, const AxisFrame& axis, bool inside) {
  require(is_length(ring), "torus", "radius of the ring", ring, LENGTH);
  require(is_length(tube) && tube < ring, "torus", "radius of the tube", tube,
          "> 0 and less than that of the ring");
  return std::make_shared<Revolved>(std::make_shared<Circle>(tube, inside), axis, ring);
}

} // namespace burnish
