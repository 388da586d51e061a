#pragma once
// A rigid tool's surface in the tool's own frame, known through points: foot, normal, curvature (METHOD.md 2.2). Curves
// of the plane come in by ProfileSurface.
#include "base/types.hpp"
#include "geometry/surface_mesh.hpp"
#include <limits>
#include <vector>

namespace burnish {

/// A place on a surface.
template <int Dim> struct SurfacePlace {
  Vector<Dim> y = Vector<Dim>::Zero(); ///< the point, in the tool's frame [length]
  Param<Dim> hint =
      Param<Dim>::Zero(); ///< where the surface's own search starts: its parameters there. It belongs to
                          ///< the surface; no formula of the contact uses it
};

/// Local geometry at a place, all in the tool's frame: dy = E d(eta), dn = E B d(eta) along the surface.
template <int Dim> struct SurfaceFrame {
  Vector<Dim> n;    ///< unit normal out of the tool, into the body
  Tangents<Dim> E;  ///< orthonormal tangents; in the plane the direction of travel
  Curvature<Dim> B; ///< E' (grad n) E, symmetric [1/length]
};

/// Closest point of a surface.
template <int Dim> struct SurfaceFoot {
  SurfacePlace<Dim> place;
  double gap = std::numeric_limits<double>::infinity(); ///< along n, positive outside the tool [length]
  bool on_end = false; ///< the foot is on the rim of an open surface: there is no normal projection
};

template <int Dim> class Surface : public SurfaceInSpace<Dim> {
public:
  virtual ~Surface() = default;
  /// Closest point to p. Of several that are equally near the one next to the hint; a node that rolls over a closed
  /// surface keeps a continuous hint. @throws std::invalid_argument if p or the hint is not finite
  virtual SurfaceFoot<Dim> foot(const Vector<Dim>& p, const Param<Dim>& hint) const = 0;
  virtual SurfaceFrame<Dim> frame(const SurfacePlace<Dim>& place) const = 0;
  /// The place that a tangential motion by E eta leads to [length]. In space: the foot of y + E eta.
  virtual SurfacePlace<Dim> moved(const SurfacePlace<Dim>& place, const Param<Dim>& eta) const {
    return foot(place.y + frame(place).E * eta, place.hint).place;
  }
  /// Slip from `from` to `to` in the tangents at `to` [length]. In space: the chord on the tangent plane; a curve gives
  /// its arc.
  virtual Param<Dim> slip(const SurfacePlace<Dim>& from, const SurfacePlace<Dim>& to) const {
    return frame(to).E.transpose() * (to.y - from.y);
  }
  /// Number of the smooth piece that holds the place; at a joint the piece that begins there. A node that passes from
  /// piece to piece has an event (METHOD.md 4.2).
  virtual int piece(const SurfacePlace<Dim>&) const { return 0; }
  /// The place at the part f (0..1) of the way from one place to another. In space: the foot of the chord's point.
  virtual SurfacePlace<Dim> between(const SurfacePlace<Dim>& from, const SurfacePlace<Dim>& to,
                                    double f) const {
    return foot((1 - f) * from.y + f * to.y, from.hint).place;
  }
  /// Part of that way just beyond the joint where the piece of `from` ends; infinity if both are on one piece.
  double passage(const SurfacePlace<Dim>& from, const SurfacePlace<Dim>& to) const {
    const int first = piece(from);
    if (piece(to) == first) return std::numeric_limits<double>::infinity();
    constexpr double located = 1e-12;
    double a = 0, b = 1;
    while (b - a > located) {
      const double middle = 0.5 * (a + b);
      (piece(between(from, to, middle)) == first ? a : b) = middle;
    }
    return b;
  }
  /// Whether the surface encloses a region of its own.
  virtual bool closed() const = 0;
  /// Rim of an open surface: in the plane its two ends; empty if it is closed.
  virtual std::vector<SurfacePlace<Dim>> ends() const = 0;
  /// Distance along the surface to its nearest end; infinity if it is closed [length].
  virtual double distance_to_end(const SurfacePlace<Dim>& place) const = 0;
  /// n places spread over the whole surface.
  virtual std::vector<SurfacePlace<Dim>> samples(int n) const = 0;
  /// The same for pictures: from end to end, with the joints of its pieces between them.
  virtual std::vector<SurfacePlace<Dim>> outline(int n) const = 0;
  /// A length that characterizes the surface (radius, length of a line), for relative tolerances.
  virtual double length_scale() const = 0;
  /// Smallest radius of curvature where the body may touch [length]; infinity for a plane.
  virtual double tightest_radius() const = 0;
};

} // namespace burnish
