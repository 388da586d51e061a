// Ball, roller, cone, ring, plate and box as scripts name them.
#include "base/error.hpp"
#include "base/sentence.hpp"
#include "geometry/arc_chain.hpp"
#include "geometry/circle.hpp"
#include "geometry/extruded.hpp"
#include "geometry/plane_surface.hpp"
#include "geometry/revolved.hpp"
#include "geometry/rounded_prism.hpp"
#include "geometry/simple_surfaces.hpp"
#include "shapes/surface_kinds.hpp"

namespace burnish {
namespace {

using Made = std::shared_ptr<const Surface<3>>;

Parameter inside_parameter() {
  return {"inside", ArgumentKind::FLAG, "true: the body on the other side, in the hollow"};
}

std::vector<double> values(const Arguments& given, const char* name, std::size_t count,
                           const char* expected) {
  std::vector<double> list = given.list(name);
  const std::string what = std::string("number of values in ") + name;
  require(list.size() == count, name, what.c_str(), list.size(), expected);
  return list;
}

double length_of(const char* where, const char* name, double value) {
  require(std::isfinite(value) && value > 0, where, name, value, "a finite number > 0");
  return value;
}

// Corners from the upper end of the axis to the lower one, with their fillets. A radius of 0 is a tip: the profile leaves the
// axis at a right angle where the ball that rounds the tip ends.
Made rounded_cone(const Vector<2>& radii, double height, double fillet, const AxisFrame& axis, bool inside) {
  std::vector<Vector<2>> points;
  const auto corner = [&](double radius, double other, double end) {
    const double z = end * height / 2;
    if (radius > 0) return Vector<2>(radius, z);
    const double sine = other / std::hypot(other, height), beyond = fillet / sine - fillet;
    return Vector<2>(beyond * other / height, z - end * beyond);
  };
  const Vector<2> upper = corner(radii[1], radii[0], 1), lower = corner(radii[0], radii[1], -1);
  points = {{0, upper[1]}, upper, lower, {0, lower[1]}};
  return std::make_shared<Revolved>(
      std::make_shared<ArcChain>(points, std::vector<double>{0, fillet, fillet, 0}, false, inside), axis);
}

Made cone_of(const Arguments& given) {
  const auto v = values(given, "cone", 3, "3: [radius at z = -height/2, radius at z = height/2, height]");
  const Vector<2> radii(v[0], v[1]);
  for (const double radius : v)
    require(std::isfinite(radius) && radius >= 0, "cone", "value", radius, "a finite number >= 0");
  require(radii.maxCoeff() > 0, "cone", "larger radius", radii.maxCoeff(), "> 0");
  const double height = length_of("cone", "height", v[2]);
  const bool first = radii[0] > 0;
  const std::string place =
      sentence("r = ", first ? radii[0] : radii[1], ", z = ", first ? -height / 2 : height / 2);
  return with_fillet("cone", given, place, std::max(radii.maxCoeff(), height),
                     [&, axis = axis_of("cone", given)](double fillet) {
                       return rounded_cone(radii, height, fillet, axis, given.flag("inside"));
                     });
}

Made cylinder_of(const Arguments& given) {
  const double radius = length_of("cylinder", "radius", given.number("cylinder", 0));
  const AxisFrame axis = axis_of("cylinder", given);
  const bool inside = given.flag("inside");
  if (!given.has("length")) {
    if (given.has("fillet"))
      fail("cylinder", "fillet= rounds the edges of the ends, and without length= there are none");
    return std::make_shared<Extruded>(std::make_shared<Circle>(radius, inside), axis);
  }
  const double length = length_of("cylinder", "length", given.number("length", 0));
  return with_fillet("cylinder", given, sentence("r = ", radius, ", z = ", length / 2),
                     std::min(radius, length / 2), [&](double fillet) {
                       return std::make_shared<RoundedPrism>(std::make_shared<Circle>(radius), axis, length,
                                                             fillet, inside);
                     });
}

Made box_of(const Arguments& given) {
  const auto v = values(given, "box", 3, "3: [length along x, along y, along z]");
  for (const double side : v) length_of("box", "side", side);
  const Vector<3> half(v[0] / 2, v[1] / 2, v[2] / 2);
  return with_fillet(
      "box", given, sentence("x = ", half[0], ", y = ", half[1]), half.minCoeff(), [&](double fillet) {
        const std::vector<Vector<2>> corners{
            {half[0], half[1]}, {-half[0], half[1]}, {-half[0], -half[1]}, {half[0], -half[1]}};
        const auto section = std::make_shared<ArcChain>(corners, std::vector<double>(4, fillet), true);
        return std::make_shared<RoundedPrism>(section, AxisFrame(), v[2], fillet, given.flag("inside"));
      });
}

} // namespace

SurfaceKind sphere_shape() {
  return {"sphere=R",
          {{"sphere", ArgumentKind::NUMBER, "ball about the origin of the tool's frame; radius [length]"},
           inside_parameter()},
          [](const Arguments& given) { return sphere(given.number("sphere", 0), {}, given.flag("inside")); }};
}

SurfaceKind cylinder_shape() {
  return {"cylinder=R",
          {{"cylinder", ArgumentKind::NUMBER, "roller about an axis through the origin; radius [length]"},
           {"length", ArgumentKind::NUMBER,
            "from end to end, half on each side of the origin; endless unless given [length]"},
           fillet_parameter(),
           axis_parameter(),
           inside_parameter()},
          cylinder_of};
}

SurfaceKind cone_shape() {
  return {"cone=[R1,R2,height]",
          {{"cone", ArgumentKind::NUMBERS,
            "radii half the height below and above the origin, one of them may be 0; height [length]"},
           fillet_parameter(),
           axis_parameter(),
           inside_parameter()},
          cone_of};
}

SurfaceKind torus_shape() {
  return {"torus=[R,r]",
          {{"torus", ArgumentKind::NUMBERS,
            "ring about the origin: radius of the circle of centers, of the tube [length]"},
           axis_parameter(),
           inside_parameter()},
          [](const Arguments& given) {
            const auto v = values(given, "torus", 2, "2: [radius of the ring, radius of the tube]");
            return torus(v[0], v[1], axis_of("torus", given), given.flag("inside"));
          }};
}

SurfaceKind plane_shape() {
  return {"plane=[x0,y0,z0,nx,ny,nz]",
          {{"plane", ArgumentKind::NUMBERS,
            "endless plane through a point, with its normal into the body [length, -]"},
           {"size", ArgumentKind::NUMBER,
            "about the extent of the body on it: the lever arm for tolerances of moments; 1 unless given "
            "[length]"}},
          [](const Arguments& given) -> Made {
            const auto v = values(given, "plane", 6, "6: [x0,y0,z0,nx,ny,nz]");
            return std::make_shared<PlaneSurface>(Vector<3>(v[0], v[1], v[2]), Vector<3>(v[3], v[4], v[5]),
                                                  given.number("size", 1));
          },
          "; turn its normal"};
}

SurfaceKind box_shape() {
  return {"box=[a,b,c]",
          {{"box", ArgumentKind::NUMBERS,
            "box about the origin: lengths along x, y and z of the tool's frame [length]"},
           fillet_parameter(),
           inside_parameter()},
          box_of};
}

} // namespace burnish
