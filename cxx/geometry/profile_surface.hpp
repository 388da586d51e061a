#pragma once
// A profile of the plane, a parametrized curve, as a tool's surface.
#include "geometry/profile.hpp"
#include "geometry/surface.hpp"
#include <memory>

namespace burnish {

/// The hint of a place is the profile's parameter s. Motion and slip are measured along the curve.
class ProfileSurface final : public Surface<2> {
public:
  /// @throws std::invalid_argument for a null profile
  explicit ProfileSurface(std::shared_ptr<const Profile<2>> profile);
  const Profile<2>& profile() const { return *m_profile; }
  /// Place of the parameter s.
  SurfacePlace<2> at(double s) const;

  SurfaceFoot<2> foot(const Vector<2>& p, const Param<2>& hint) const override;
  SurfaceFrame<2> frame(const SurfacePlace<2>& place) const override;
  /// Goes on beyond an end as the profile does.
  SurfacePlace<2> moved(const SurfacePlace<2>& place, const Param<2>& eta) const override;
  Param<2> slip(const SurfacePlace<2>& from, const SurfacePlace<2>& to) const override;
  int piece(const SurfacePlace<2>& place) const override;
  SurfacePlace<2> between(const SurfacePlace<2>& from, const SurfacePlace<2>& to, double f) const override;
  bool closed() const override { return m_profile->range().closed; }
  std::vector<SurfacePlace<2>> ends() const override;
  double distance_to_end(const SurfacePlace<2>& place) const override;
  std::vector<SurfacePlace<2>> samples(int n) const override;
  std::vector<SurfacePlace<2>> outline(int n) const override;
  double length_scale() const override { return m_profile->length_scale(); }
  double tightest_radius() const override { return m_profile->tightest_radius(); }

private:
  void add_joints(double a, double b, std::vector<SurfacePlace<2>>& places) const;
  std::shared_ptr<const Profile<2>> m_profile;
};

} // namespace burnish
