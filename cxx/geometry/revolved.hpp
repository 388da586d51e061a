#pragma once
// A profile turned about an axis: balls, rollers, cones, rings, dies with fillets.
#include "geometry/axis_frame.hpp"
#include "geometry/profile_surface.hpp"

namespace burnish {

/// The profile's x is the distance r from the axis, its y runs along the axis; the side of the body is the
/// profile's. What the profile has at r < 0 must be the mirror image of the rest (a circle about a point of the
/// axis) and is not used. Foot and curvature: METHOD.md 2.2, tangents along and across the meridian. The hint of a
/// place is (s, angle): the profile's parameter, which the place keeps, and the angle about the axis, which counts
/// for points on the axis only. A profile that meets the axis at a right angle goes on smoothly there (a pole); one
/// that does otherwise has its apex there, an end without a normal.
class Revolved final : public Surface<3> {
public:
  /// @param profile in the half-plane (r, along the axis)
  /// @param axis    in the tool's frame
  /// @param radius  r of the origin of the profile: a circle turned about an axis beside it is a torus [length]
  /// @throws std::invalid_argument for a null profile, a radius that is not finite or negative, a profile that has at
  /// r < 0 more than the mirror image (names the place) or lies on the axis
  explicit Revolved(std::shared_ptr<const Profile<2>> profile, const AxisFrame& axis = {}, double radius = 0);

  SurfaceFoot<3> foot(const Vector<3>& p, const Param<3>& hint) const override;
  SurfaceFrame<3> frame(const SurfacePlace<3>& place) const override;
  int piece(const SurfacePlace<3>& place) const override { return m_meridian.piece(meridian_place(place)); }
  /// True if the profile is closed or begins and ends at poles.
  bool closed() const override;
  /// RIM_PLACES places on the circle of each end of the profile, one at an apex, none at a pole.
  std::vector<SurfacePlace<3>> ends() const override;
  double distance_to_end(const SurfacePlace<3>& place) const override;
  std::vector<SurfacePlace<3>> samples(int n) const override;
  /// The profile, in the half-plane of the first direction of the axis' frame.
  std::vector<SurfacePlace<3>> outline(int n) const override;
  SurfaceMesh mesh(const Eigen::AlignedBox3d& window) const override;
  /// Largest distance from the axis [length].
  double length_scale() const override { return m_largest; }
  /// That of the profile, or of the circles about the axis where they are tighter (at the places of an outline).
  double tightest_radius() const override { return m_tightest; }

  static constexpr int RIM_PLACES = 24;

private:
  SurfacePlace<2> meridian_place(const SurfacePlace<3>& place) const;
  SurfacePlace<3> turned(const SurfacePlace<2>& place, double angle) const;
  double distance(const SurfacePlace<2>& place) const { return place.y[0] + m_radius; }
  double curvature_around(double r, const SurfaceFrame<2>& meridian) const;
  bool at_pole(double r, const SurfaceFrame<2>& meridian) const;
  void check_mirror(const std::vector<SurfacePlace<2>>& places) const;

  ProfileSurface m_meridian;
  AxisFrame m_axis;
  double m_radius, m_largest = 0, m_tightest;
  std::vector<SurfacePlace<2>> m_ends; ///< of the profile, without poles
};

} // namespace burnish
