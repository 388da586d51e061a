#pragma once
// A closed profile swept along a straight line between two flat ends whose edges are rounded: boxes, rollers, punches.
#include "geometry/axis_frame.hpp"
#include "geometry/profile_surface.hpp"

namespace burnish {

/// Of a section and a length the points within a fillet's radius of the inner prism, whose section is the profile moved
/// inwards by that radius: walls, flat ends, and between them edges of the fillet's radius (METHOD.md 2.2). Tangents: along
/// the profile and across it; on a flat end two fixed ones. The hint of a place is the profile's parameter and how far
/// along the way it is.
class RoundedPrism final : public Surface<3> {
public:
  /// @param section closed, the body outside; in the first two directions of the frame
  /// @param frame   in the tool's frame; its point is half-way between the ends
  /// @param length  from end to end along the third direction [length]
  /// @param fillet  radius of the edges of both ends [length]
  /// @param inside  true: the body is in the hollow
  /// @throws std::invalid_argument for a section that is null or open, a length or fillet that is not finite or <= 0, a
  /// fillet beyond half the length, and one that does not roll along the section from within (names the place)
  RoundedPrism(std::shared_ptr<const Profile<2>> section, const AxisFrame& frame, double length,
               double fillet, bool inside = false);

  SurfaceFoot<3> foot(const Vector<3>& p, const Param<3>& hint) const override;
  SurfaceFrame<3> frame(const SurfacePlace<3>& place) const override;
  /// Walls and edges of each piece of the section, and the two flat ends.
  int piece(const SurfacePlace<3>& place) const override;
  bool closed() const override { return true; }
  std::vector<SurfacePlace<3>> ends() const override { return {}; }
  double distance_to_end(const SurfacePlace<3>&) const override {
    return std::numeric_limits<double>::infinity();
  }
  std::vector<SurfacePlace<3>> samples(int n) const override;
  /// The section in the middle of the way.
  std::vector<SurfacePlace<3>> outline(int n) const override;
  SurfaceMesh mesh(const Eigen::AlignedBox3d& window) const override;
  /// That of the section, or half the length if it is more [length].
  double length_scale() const override { return std::max(m_section.length_scale(), m_inner + m_fillet); }
  double tightest_radius() const override { return std::min(m_fillet, m_section.tightest_radius()); }

private:
  /// A point of the frame as the surface sees it: the section's closest point, and distances out of the inner prism.
  struct Seen {
    SurfacePlace<2> place;
    double gap;        ///< from the section, positive outside it
    double out, along; ///< out of the inner prism across and along the way; <= 0: within it
    double end;        ///< +1 or -1: the nearer end
  };
  Seen seen(const Vector<3>& local, const Param<3>& hint) const;
  void check_fillet() const;
  Vector<2> center() const;
  SurfacePlace<3> at(const Vector<2>& y, double along, double s) const {
    return {m_frame.global(Vector<3>(y[0], y[1], along)), Param<3>(s, along)};
  }
  void add_end(SurfaceMesh& mesh, const std::vector<SurfacePlace<2>>& outline, double end) const;

  ProfileSurface m_section;
  AxisFrame m_frame;
  double m_fillet, m_inner; ///< half the length of the inner prism
  double m_side;            ///< +1: the body is outside
};

} // namespace burnish
