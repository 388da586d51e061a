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
  AxisFrame frame = axis_frame(where, Vector<3>::Zero(), direction);
  const Vector<3> z = frame.base.col(2);
  const double across = z.head<2>().squaredNorm(); // squared sine of the angle; h: 1 + its cosine
  const double h = z[2] > 0 ? 1 + z[2] : across / (1 - z[2]);
  Vector<3> x = Vector<3>::UnitX();
  if (h > 0) x = Vector<3>(1 - z[0] * z[0] / h, -z[0] * z[1] / h, -z[0]).normalized();
  frame.base.col(0) = x;
  frame.base.col(1) = z.cross(x);
  return frame;
}

} // namespace burnish
