#pragma once
// Interface of a tool's profile in the tool's own frame. Closed forms and CAD curves implement it.
#include "base/types.hpp"
#include <array>

namespace burnish {

/// Point of a profile with its derivatives along the surface parameters s.
template <int Dim> struct ProfilePoint {
  Vector<Dim> x;                           ///< point [length]
  Tangents<Dim> x_s;                       ///< dx/ds
  std::array<Tangents<Dim>, Dim - 1> x_ss; ///< x_ss[a].col(b) = d2x/ds^a ds^b
  Vector<Dim> n;                           ///< unit normal, out of the tool [-]
  Tangents<Dim> n_s;                       ///< dn/ds
};

/// Nearest point of a profile.
template <int Dim> struct ClosestPoint {
  Param<Dim> s; ///< parameter of the foot point
  double gap;   ///< signed distance along n, positive outside the tool [length]
  bool on_end;  ///< true if the foot point is an end of the profile (no normal projection)
};

/// Where the parameters of a profile lie. Closed profiles are periodic: s may run on beyond both ends.
template <int Dim> struct ParamRange {
  Param<Dim> begin, end;
  bool closed;
};

template <int Dim> class Profile {
public:
  virtual ~Profile() = default;
  /// Point, tangent, normal and second derivatives at s (s in the unit of the profile, 2D: arc length
  /// or any smooth parameter). Total: also defined a little beyond the ends by smooth continuation.
  virtual ProfilePoint<Dim> evaluate(const Param<Dim>& s) const = 0;
  /// Closest point to x (own frame). For a periodic profile the parameter nearest to `near` is returned,
  /// so that a rolling node keeps a continuous parameter.
  virtual ClosestPoint<Dim> closest_point(const Vector<Dim>& x, const Param<Dim>& near) const = 0;
  /// A length that characterises the profile (radius, length of a line), for relative tolerances.
  virtual double length_scale() const = 0;
  /// Parameters of the whole profile, for outlines.
  virtual ParamRange<Dim> range() const = 0;
  /// Smallest radius of curvature where the body may touch [length]; infinity for a straight line.
  virtual double tightest_radius() const = 0;
  /// Number of the smooth piece that holds s, 0, 1, ...; at a joint the piece that begins there. A node that
  /// passes from piece to piece has an event (METHOD.md 4.2).
  virtual int piece(const Param<Dim>&) const { return 0; }
};

} // namespace burnish
