#pragma once
// Named parameters of a tool that choose its profile.
#include "geometry/profile.hpp"
#include "named.hpp"

namespace burnish {

/// The entries of names[] for shape_of().
#define BURNISH_SHAPE_NAMES                                                                                  \
  {"circle", &typeid(double)}, {"line", &typeid(NumberList*)}, {"chain", &typeid(NumberList*)},              \
      {"closed", &typeid(bool)}, {"cad", &typeid(string*)}, {"curves", &typeid(NumberList*)},                \
      {"scale", &typeid(double)}, {"geo", &typeid(string*)}, {                                               \
    "inside", &typeid(bool)                                                                                  \
  }
constexpr int SHAPE_NAMES = 9;

/// circle=R | line=[x0,y0, x1,y1] | chain=[x0,y0,r0, x1,y1,r1, ...], closed=true | cad="file.step",
/// curves=[1,2], scale=1e-3, geo="R=10e-3; H=2e-3"; inside=true for all but a line.
/// @throws std::invalid_argument for none or several of them, for a parameter of another one, and what the
/// core's profiles refuse
std::shared_ptr<const Profile<2>> shape_of(const Named& named);

} // namespace burnish
