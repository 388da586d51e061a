#pragma once
// Ball, roller, cone and ring as surfaces of space: circles and lines turned about an axis.
#include "geometry/axis_frame.hpp"
#include "geometry/surface.hpp"
#include <memory>

namespace burnish {

/// About the axis' point. @param inside true: the body is in the hollow, here and below
/// @throws std::invalid_argument, as all of these, for lengths that are not positive and finite
std::shared_ptr<const Surface<3>> sphere(double radius, const AxisFrame& axis = {}, bool inside = false);

/// From the axis' point along the axis, open at both ends.
std::shared_ptr<const Surface<3>> cylinder(double radius, double length, const AxisFrame& axis = {},
                                           bool inside = false);

/// A cone of two radii, the first at the axis' point, the second a height further on; open at both ends. A radius
/// of 0: one nappe, whose apex has no normal.
/// @throws std::invalid_argument if a radius is negative, both are 0
std::shared_ptr<const Surface<3>> cone(double first_radius, double second_radius, double height,
                                       const AxisFrame& axis = {}, bool inside = false);

/// A tube about a circle of radius `ring` about the axis' point.
/// @throws std::invalid_argument unless 0 < tube < ring
std::shared_ptr<const Surface<3>> torus(double ring, double tube, const AxisFrame& axis = {},
                                        bool inside = false);

} // namespace burnish
