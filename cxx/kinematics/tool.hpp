#pragma once
// A rigid tool: a surface placed by generalized coordinates, x = o(q) + s(q) R(q) y, METHOD.md (2.1), (2.17).
#include "geometry/surface.hpp"
#include "kinematics/coordinates.hpp"
#include <array>
#include <memory>
#include <string>

namespace burnish {

/// A point of a placed tool with what the linearization needs (METHOD.md (2.5)). d(eta) is a motion along the tangents,
/// dx = E d(eta) + sum X_k dq^k, d2x/d(eta)2 = -n B. E_q is that of the unit tangents; X_k changes along the tool by
/// E_,k + growth_k E, METHOD.md (2.18).
template <int Dim> struct SurfacePoint {
  Vector<Dim> x, n;                            ///< point; unit normal out of the tool, into the body
  Tangents<Dim> E;                             ///< orthonormal tangents
  Curvature<Dim> B;                            ///< curvature in them: dn = E B d(eta) [1/length]
  PerCoordinate<Dim> x_q, n_q;                 ///< X_,k ; n_,k
  std::array<PerCoordinate<Dim>, Dim - 1> E_q; ///< E_q[a].col(k) = dE_a/dq^k
  std::vector<PerCoordinate<Dim>> x_qq;        ///< x_qq[k].col(l) = d2X/dq^k dq^l
  double size = 1;                             ///< lengths along the tool over those in its own frame
  Eigen::RowVectorXd growth;                   ///< size_,k / size; empty: none
};

template <int Dim> class Tool {
public:
  /// @throws std::invalid_argument if the name is empty or a pointer is null
  Tool(std::string name, std::shared_ptr<const Surface<Dim>> surface,
       std::shared_ptr<const Coordinates<Dim>> coordinates);
  const std::string& name() const { return m_name; }
  const Surface<Dim>& surface() const { return *m_surface; }
  const Coordinates<Dim>& coordinates() const { return *m_coordinates; }
  /// The point at a place of the surface, with all derivatives.
  /// @param q  generalized coordinates, size of coordinates() [length or rad]
  /// @throws std::invalid_argument if q has the wrong size or is not finite
  SurfacePoint<Dim> point(const Eigen::VectorXd& q, const SurfacePlace<Dim>& place) const;
  /// The same from a pose computed once for many points. The pose must be one of coordinates().
  SurfacePoint<Dim> point(const Pose<Dim>& pose, const SurfacePlace<Dim>& place) const;
  /// Where a place of the surface is [length].
  Vector<Dim> position(const Pose<Dim>& pose, const SurfacePlace<Dim>& place) const {
    return pose.origin + pose.R * (pose.size * place.y);
  }
  /// Closest point of the tool to x, a point of space [length]; the gap is positive outside the tool.
  /// @param hint of a place nearby, see SurfacePlace
  SurfaceFoot<Dim> foot(const Pose<Dim>& pose, const Vector<Dim>& x, const Param<Dim>& hint) const;

private:
  std::string m_name;
  std::shared_ptr<const Surface<Dim>> m_surface;
  std::shared_ptr<const Coordinates<Dim>> m_coordinates;
};

} // namespace burnish
