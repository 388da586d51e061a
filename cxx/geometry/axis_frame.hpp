#pragma once
// Frames about an axis of space: of revolution, of extrusion.
#include "base/types.hpp"

namespace burnish {

/// Right-handed, orthonormal: p = point + base l, where l are the numbers of p in the frame. The third column of
/// the base is the direction of the axis. Default: the frame of the tool, about its z axis.
struct AxisFrame {
  Vector<3> point = Vector<3>::Zero();    ///< on the axis [length]
  Tensor<3> base = Tensor<3>::Identity(); ///< columns e1, e2, direction
  Vector<3> local(const Vector<3>& p) const { return base.transpose() * (p - point); }
  Vector<3> global(const Vector<3>& l) const { return point + base * l; }
};

/// @param direction of the axis, any length > 0; @param across  e1 is its part normal to the axis
/// @throws std::invalid_argument "where: ..." for numbers that are not finite, a direction of length 0, an across
/// along it
AxisFrame axis_frame(const char* where, const Vector<3>& point, const Vector<3>& direction,
                     const Vector<3>& across);
/// The same with some e1, where it does not matter.
AxisFrame axis_frame(const char* where, const Vector<3>& point, const Vector<3>& direction);
/// The frame of the tool turned the shortest way from its z axis to the direction; from z to -z about x.
AxisFrame turned_frame(const char* where, const Vector<3>& direction);

} // namespace burnish
