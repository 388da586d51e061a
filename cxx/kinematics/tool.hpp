#pragma once
// A rigid tool: a profile placed by generalized coordinates, x = X(q, s)  (method.md section 2).
#include "geometry/profile.hpp"
#include "kinematics/coordinates.hpp"
#include <memory>
#include <string>

namespace burnish {

/// Surface map X(q,s) with the complete first and second derivatives (article eq. 1.2).
template <int Dim> struct SurfacePoint {
  Vector<Dim> x, n;                             ///< point; unit normal out of the tool, into the body
  Tangents<Dim> x_s, n_s;                       ///< X_,s ; n_,s
  std::array<Tangents<Dim>, Dim - 1> x_ss;      ///< x_ss[a].col(b)
  PerCoordinate<Dim> x_q, n_q;                  ///< X_,k ; n_,k
  std::array<PerCoordinate<Dim>, Dim - 1> x_qs; ///< x_qs[a].col(k) = d2X/dq^k ds^a
  std::vector<PerCoordinate<Dim>> x_qq;         ///< x_qq[k].col(l) = d2X/dq^k dq^l
};

template <int Dim> class Tool {
public:
  /// @throws std::invalid_argument if the name is empty or a pointer is null
  Tool(std::string name, std::shared_ptr<const Profile<Dim>> profile,
       std::shared_ptr<const Coordinates<Dim>> coordinates);
  const std::string& name() const { return m_name; }
  const Profile<Dim>& profile() const { return *m_profile; }
  const Coordinates<Dim>& coordinates() const { return *m_coordinates; }
  /// X(q,s) = origin(q) + R(q) xhat(s), n = R nhat, and all derivatives (article eq. 1.2,
  /// method.md section 2).
  /// @param q  generalized coordinates, size of coordinates() [length or rad]
  /// @param s  surface parameters, in the profile's unit
  /// @throws std::invalid_argument if q has the wrong size or is not finite;
  /// the profile throws if s is not finite
  SurfacePoint<Dim> surface(const Eigen::VectorXd& q, const Param<Dim>& s) const;
  /// The same from a pose computed once for many points. The pose must be one of coordinates().
  SurfacePoint<Dim> surface(const Pose<Dim>& pose, const Param<Dim>& s) const;
  /// Closest point to x in space, 2 or 3 [length]; `near` picks the branch of a periodic parameter. The gap
  /// is positive outside the tool; errors are those of the profile.
  ClosestPoint<Dim> closest_point(const Pose<Dim>& pose, const Vector<Dim>& x, const Param<Dim>& near) const;

private:
  std::string m_name;
  std::shared_ptr<const Profile<Dim>> m_profile;
  std::shared_ptr<const Coordinates<Dim>> m_coordinates;
};

} // namespace burnish
