#include "geometry/axis_frame.hpp"
#include "base/error.hpp"

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

} // namespace burnish
