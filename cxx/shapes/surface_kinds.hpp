#pragma once
// The kinds of tool surfaces in space that a script can name.
#include "geometry/axis_frame.hpp"
#include "geometry/shape_kind.hpp"

namespace burnish {

SurfaceKind sphere_shape();   ///< "sphere=R"
SurfaceKind cylinder_shape(); ///< "cylinder=R"
SurfaceKind cone_shape();     ///< "cone=[R1,R2,height]"
SurfaceKind torus_shape();    ///< "torus=[ring,tube]"
SurfaceKind plane_shape();    ///< "plane=[x0,y0,z0,nx,ny,nz]"
SurfaceKind box_shape();      ///< "box=[a,b,c]"
SurfaceKind revolve_shape();  ///< "revolve=true" with a profile
SurfaceKind extrude_shape();  ///< "extrude=true" with a profile

// Functions, as a plugin may ask for them while it is loaded.
Parameter axis_parameter();   ///< "axis="
Parameter fillet_parameter(); ///< "fillet="

/// The axis that `axis=` names, z of the tool's frame unless given.
/// @throws std::invalid_argument "where: ..." for what is no direction
AxisFrame axis_of(const char* where, const Arguments& given);

/// The shape whose edges have the radius `fillet=`.
/// @param place where an edge is, for messages: "r = 2, z = -1"
/// @param most  radius beyond which nothing can fit [length]
/// @param make  of a fillet; throws where it does not fit
/// @throws std::invalid_argument "where: ..." without a fillet and for one that does not fit: names the place and the
/// largest fillet
std::shared_ptr<const Surface<3>>
with_fillet(const char* where, const Arguments& given, const std::string& place, double most,
            const std::function<std::shared_ptr<const Surface<3>>(double)>& make);

} // namespace burnish
