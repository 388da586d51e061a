#include "geometry/axis_frame.hpp"
#include "base/error.hpp"
#include <Eigen/Geometry>

namespace burnish {

AxisFrame axis_frame(const char* where, const Vector<3>& point, const Vector<3>& direction,
                     const Vector<3>& across) {
  constexpr double parallel = 1e-6; // sine of the angle between both
  require(point.allFinite(), where, "point of the axis", point.transpose(), "finite components");
  require(direction.allFinite() && direction.norm() > 0, where, "direction of the axis",
          direction.transpose(), "finite components, not all 0");
  require(across.allFinite() && across.cross(direction).norm() > parallel * across.norm() * direction.norm(),
          where, "direction across the axis", across.transpose(), "finite components, not along the axis");
  AxisFrame frame;
  frame.point = point;
  frame.base.col(2) = direction.normalized();
  frame.base.col(1) = frame.base.col(2).cross(across).normalized();
  frame.base.col(0) = frame.base.col(1).cross(frame.base.col(2)).normalized();
  return frame;
}

AxisFrame axis_frame(const char* where, const Vector<3>& point, const Vector<3>& direction) {
  int least = 0;
  direction.cwiseAbs().minCoeff(&least);
  return axis_frame(where, point, direction, Vector<3>::Unit(least));
}

AxisFrame turned_frame(const char* where, const Vector<3>& direction) {
  constexpr double opposite = 1e-9;
  AxisFrame frame = axis_frame(where, Vector<3>::Zero(), direction);
  const Vector<3> axis = frame.base.col(2);
  if (axis.head<2>().norm() > opposite ||
      axis[2] > 0) // by half the angle from z to the axis, about what is across both
    frame.base = Eigen::Quaterniond(1 + axis[2], -axis[1], axis[0], 0).normalized().toRotationMatrix();
  else
    frame.base = Vector<3>(1, -1, -1).asDiagonal();
  return frame;
}

} // namespace burnish
