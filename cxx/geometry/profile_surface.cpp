#include "geometry/profile_surface.hpp"
#include "base/error.hpp"
#include <cmath>

namespace burnish {

ProfileSurface::ProfileSurface(std::shared_ptr<const Profile<2>> profile) : m_profile(std::move(profile)) {
  if (!m_profile) fail("tool", "no profile");
}

SurfacePlace<2> ProfileSurface::at(double s) const {
  const Param<2> parameter(s);
  return {m_profile->evaluate(parameter).x, parameter};
}

SurfaceFoot<2> ProfileSurface::foot(const Vector<2>& p, const Param<2>& hint) const {
  const ClosestPoint<2> nearest = m_profile->closest_point(p, hint);
  return {at(nearest.s[0]), nearest.gap, nearest.on_end};
}

SurfaceFrame<2> ProfileSurface::frame(const SurfacePlace<2>& place) const {
  const ProfilePoint<2> point = m_profile->evaluate(place.hint);
  const double speed = point.x_s.norm();
  SurfaceFrame<2> frame;
  frame.n = point.n;
  frame.E = point.x_s / speed;
  frame.B = frame.E.transpose() * point.n_s / speed;
  return frame;
}

SurfacePlace<2> ProfileSurface::moved(const SurfacePlace<2>& place, const Param<2>& eta) const {
  return at(place.hint[0] + eta[0] / m_profile->evaluate(place.hint).x_s.norm());
}

Param<2> ProfileSurface::slip(const SurfacePlace<2>& from, const SurfacePlace<2>& to) const {
  return (to.hint - from.hint) * m_profile->evaluate(to.hint).x_s.norm();
}

int ProfileSurface::piece(const SurfacePlace<2>& place) const { return m_profile->piece(place.hint); }

SurfacePlace<2> ProfileSurface::between(const SurfacePlace<2>& from, const SurfacePlace<2>& to,
                                        double f) const {
  return at((from.hint + f * (to.hint - from.hint))[0]);
}

std::vector<SurfacePlace<2>> ProfileSurface::ends() const {
  const ParamRange<2> range = m_profile->range();
  if (range.closed) return {};
  return {at(range.begin[0]), at(range.end[0])};
}

double ProfileSurface::distance_to_end(const SurfacePlace<2>& place) const {
  const ParamRange<2> range = m_profile->range();
  if (range.closed) return std::numeric_limits<double>::infinity();
  const double speed = m_profile->evaluate(place.hint).x_s.norm();
  return std::min((place.hint - range.begin).norm(), (range.end - place.hint).norm()) * speed;
}

std::vector<SurfacePlace<2>> ProfileSurface::samples(int n) const {
  const ParamRange<2> range = m_profile->range();
  std::vector<SurfacePlace<2>> places;
  for (int i = 0; i < n; ++i) places.push_back(at((range.begin + (range.end - range.begin) * i / n)[0]));
  return places;
}

// Joints after that of a, up to that of b; pieces are numbered along s.
void ProfileSurface::add_joints(double a, double b, std::vector<SurfacePlace<2>>& places) const {
  const int last = m_profile->piece(Param<2>(b));
  for (int k = m_profile->piece(Param<2>(a)) + 1; k <= last; ++k) {
    double low = a, high = b;
    while (high - low > 1e-14 * (std::abs(low) + std::abs(high))) {
      const double middle = (low + high) / 2;
      if (middle <= low || middle >= high) break;
      (m_profile->piece(Param<2>(middle)) < k ? low : high) = middle;
    }
    if (high < b) places.push_back(at(high));
  }
}

std::vector<SurfacePlace<2>> ProfileSurface::outline(int n) const {
  const ParamRange<2> range = m_profile->range();
  const double begin = range.begin(0), end = range.end(0), step = (end - begin) / (n - 1.);
  std::vector<SurfacePlace<2>> places;
  for (int i = 0; i + 1 < n; ++i) {
    const double a = begin + i * step;
    places.push_back(at(a));
    // a closed profile begins again at its end
    add_joints(a, i + 2 < n ? a + step : end - 1e-9 * (end - begin), places);
  }
  places.push_back(at(end));
  return places;
}

} // namespace burnish
