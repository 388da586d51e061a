#pragma once
// What every plane profile must satisfy; used by the tests of each of them.
#include "geometry/profile.hpp"
#include "unit/finite_difference.hpp"

namespace burnish::test {

/// x_s, x_ss, n_s against finite differences at s; unit normal, orthogonal to the tangent.
/// param_scale: change of s over which the profile changes noticeably.
inline void check_profile_derivatives(const Profile<2>& profile, double s, double param_scale) {
  SCOPED_TRACE("s = " + std::to_string(s));
  const double length = profile.length_scale(), step = 1e-3 * param_scale, tolerance = 1e-10;
  const auto at = [&](double t) { return profile.evaluate(Param<2>(t)); };
  const ProfilePoint<2> point = at(s);
  const Vector<2> x_s = finite_difference([&](double t) { return at(t).x; }, s, step);
  const Vector<2> x_ss = finite_difference([&](double t) { return Vector<2>(at(t).x_s); }, s, step);
  const Vector<2> n_s = finite_difference([&](double t) { return at(t).n; }, s, step);
  expect_close(point.x_s, x_s, length / param_scale, tolerance, "x_s");
  expect_close(point.x_ss[0], x_ss, length / (param_scale * param_scale), tolerance, "x_ss");
  expect_close(point.n_s, n_s, 1 / param_scale, tolerance, "n_s");
  EXPECT_NEAR(point.n.norm(), 1, 1e-15);
  EXPECT_NEAR(point.n.dot(point.x_s) / point.x_s.norm(), 0, 1e-15);
}

/// Foot point of x = x(s) + distance n(s): parameter, gap, orthogonality.
/// Valid while the foot point is unique and not an end.
inline void check_foot_point(const Profile<2>& profile, double s, double distance, double param_scale) {
  SCOPED_TRACE("s = " + std::to_string(s) + ", distance = " + std::to_string(distance));
  const double length = profile.length_scale();
  const ProfilePoint<2> origin = profile.evaluate(Param<2>(s));
  const Vector<2> x = origin.x + distance * origin.n;
  const ClosestPoint<2> closest = profile.closest_point(x, Param<2>(s));
  EXPECT_FALSE(closest.on_end);
  EXPECT_NEAR(closest.s(0) / param_scale, s / param_scale, 1e-13);
  EXPECT_NEAR(closest.gap / length, distance / length, 1e-14);
  const ProfilePoint<2> foot = profile.evaluate(closest.s);
  EXPECT_NEAR((x - foot.x).dot(foot.x_s) / (length * foot.x_s.norm()), 0, 1e-14);
  expect_close(foot.x + closest.gap * foot.n, x, length, 1e-14, "foot + gap n");
}

} // namespace burnish::test
