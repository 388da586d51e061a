#pragma once
// The plane of space: a plate that the body never leaves.
#include "geometry/axis_frame.hpp"
#include "geometry/surface.hpp"

namespace burnish {

/// Endless plane. The hint is not used.
class PlaneSurface final : public Surface<3> {
public:
  /// @param point  of the plane, in the tool's frame [length]
  /// @param normal out of the tool, into the body; any length > 0
  /// @param size   side of the square about the point that samples and pictures show; the scale of tolerances
  /// [length]
  /// @throws std::invalid_argument for a normal of length 0, size <= 0, or numbers that are not finite
  PlaneSurface(const Vector<3>& point, const Vector<3>& normal, double size);

  SurfaceFoot<3> foot(const Vector<3>& p, const Param<3>& hint) const override;
  SurfaceFrame<3> frame(const SurfacePlace<3>& place) const override;
  bool closed() const override { return false; }
  std::vector<SurfacePlace<3>> ends() const override { return {}; }
  double distance_to_end(const SurfacePlace<3>&) const override {
    return std::numeric_limits<double>::infinity();
  }
  std::vector<SurfacePlace<3>> samples(int n) const override;
  /// Across the square, through the point.
  std::vector<SurfacePlace<3>> outline(int n) const override;
  SurfaceMesh mesh(const Eigen::AlignedBox3d& window) const override;
  double length_scale() const override { return m_size; }
  double tightest_radius() const override { return std::numeric_limits<double>::infinity(); }

private:
  AxisFrame m_frame; ///< the third direction is the normal
  double m_size;
};

} // namespace burnish
