#pragma once
// A profile swept along a straight line: rollers and bars, beds, dies of one cross section.
#include "geometry/axis_frame.hpp"
#include "geometry/profile_surface.hpp"
#include <cmath>

namespace burnish {

/// The profile lies in the first two directions of the frame and is swept along the third, from the frame's point
/// by the length, or both ways without an end; open at both ends of the way, whatever the profile. Curvature: METHOD.md 2.2, tangents along and
/// across the profile. The hint of a place is the profile's parameter s, which the place keeps, and how far along
/// the way it is.
class Extruded final : public Surface<3> {
public:
  /// @param frame  in the tool's frame
  /// @param length of the way; endless unless given [length]
  /// @throws std::invalid_argument for a null profile and a length that is nan or <= 0
  Extruded(std::shared_ptr<const Profile<2>> profile, const AxisFrame& frame,
           double length = std::numeric_limits<double>::infinity());

  /// Beyond an end of the profile or of the way: as Segment, gap = +distance to that rim, on_end = true; an excess of
  /// 1e-12 of the length over an end of the way still counts as the end itself.
  SurfaceFoot<3> foot(const Vector<3>& p, const Param<3>& hint) const override;
  SurfaceFrame<3> frame(const SurfacePlace<3>& place) const override;
  int piece(const SurfacePlace<3>& place) const override { return m_section.piece(section_place(place)); }
  bool closed() const override { return false; }
  /// RIM_PLACES places along each end of the way, and along each end of the profile (endless: along its scale on both
  /// sides of the frame's point).
  std::vector<SurfacePlace<3>> ends() const override;
  double distance_to_end(const SurfacePlace<3>& place) const override;
  /// Endless: within its scale on both sides of the frame's point.
  std::vector<SurfacePlace<3>> samples(int n) const override;
  /// The profile in the middle of the way.
  std::vector<SurfacePlace<3>> outline(int n) const override;
  SurfaceMesh mesh(const Eigen::AlignedBox3d& window) const override;
  /// That of the profile [length].
  double length_scale() const override { return m_section.length_scale(); }
  double tightest_radius() const override { return m_section.tightest_radius(); }

  static constexpr int RIM_PLACES = 24;

private:
  SurfacePlace<2> section_place(const SurfacePlace<3>& place) const { return m_section.at(place.hint[0]); }
  bool endless() const { return std::isinf(m_length); }
  /// Part f (0..1) of the way, of what is shown of an endless one.
  double way(double f) const { return endless() ? (2 * f - 1) * length_scale() : f * m_length; }
  SurfacePlace<3> swept(const SurfacePlace<2>& place, double along) const;

  ProfileSurface m_section;
  AxisFrame m_frame;
  double m_length;
};

} // namespace burnish
