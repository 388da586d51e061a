#pragma once
// Random profiles: what is left to check of any plane profile when nothing is known of its shape.
#include "geometry/profile.hpp"
#include <algorithm>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace burnish::test {

class Random {
public:
  explicit Random(unsigned seed) : m_engine(seed) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(m_engine);
  }
  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(m_engine); }
  bool chance(double probability) { return between(0, 1) < probability; }
  /// 10^low to 10^high, every decade as likely as the others
  double decades(double low, double high) { return std::pow(10, between(low, high)); }
  Vector<2> point(double size) { return {between(-size, size), between(-size, size)}; }

private:
  std::mt19937 m_engine;
};

/// Equally spaced parameters and their points, both ends included.
struct Sampled {
  explicit Sampled(const Profile<2>& profile, int n = 2000) {
    const auto range = profile.range();
    low = high = profile.evaluate(range.begin).x;
    for (int i = 0; i <= n; ++i) {
      x.push_back(profile.evaluate(Param<2>(range.begin(0) + (range.end(0) - range.begin(0)) * i / n)).x);
      low = low.cwiseMin(x.back());
      high = high.cwiseMax(x.back());
      if (i > 0) spacing = std::max(spacing, (x[i] - x[i - 1]).norm());
    }
  }
  double extent() const { return (high - low).norm(); }
  double distance(const Vector<2>& from) const {
    double least = (x[0] - from).norm();
    for (const auto& point : x) least = std::min(least, (point - from).norm());
    return least;
  }
  /// Of a closed curve: true if it winds about the point.
  bool around(const Vector<2>& point) const {
    double angle = 0;
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
      const Vector<2> a = x[i] - point, b = x[i + 1] - point;
      angle += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    }
    return std::abs(angle) > M_PI;
  }
  std::vector<Vector<2>> x;
  Vector<2> low, high;
  double spacing = 0;
};

/// Least distance of the ends of two segments from the other segment; 0 if they cross (and are not parallel).
inline double apart(const Vector<2>& a, const Vector<2>& b, const Vector<2>& c, const Vector<2>& d) {
  const auto cross = [](const Vector<2>& u, const Vector<2>& v) { return u.x() * v.y() - u.y() * v.x(); };
  const auto between = [&](const Vector<2>& e, const Vector<2>& f, const Vector<2>& g, const Vector<2>& h) {
    return cross(f - e, g - e) * cross(f - e, h - e) <= 0;
  };
  const bool parallel = std::abs(cross(b - a, d - c)) <= 1e-6 * (b - a).norm() * (d - c).norm();
  if (!parallel && between(a, b, c, d) && between(c, d, a, b)) return 0;
  const auto from = [](const Vector<2>& e, const Vector<2>& f, const Vector<2>& x) {
    const double part = std::clamp((x - e).dot(f - e) / (f - e).squaredNorm(), 0., 1.);
    return (e + part * (f - e) - x).norm();
  };
  return std::min({from(a, b, c), from(a, b, d), from(c, d, a), from(c, d, b)});
}

/// True if a polygon, without repeated points, comes as close to itself as `reach` where it is longer than
/// `aside` in between [length]. A closed one ends with its first point.
inline bool polygon_meets_itself(const std::vector<Vector<2>>& line, bool closed, double reach,
                                 double aside) {
  std::vector<double> s{0};
  for (std::size_t i = 1; i < line.size(); ++i) s.push_back(s.back() + (line[i] - line[i - 1]).norm());
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    for (std::size_t j = i + 2; j + 1 < line.size(); ++j) {
      const double around = closed ? s.back() - s[j + 1] + s[i] : s.back();
      if (std::min(s[j] - s[i + 1], around) <= aside) continue;
      if (apart(line[i], line[i + 1], line[j], line[j + 1]) <= reach) return true;
    }
  return false;
}

/// Closest points of random places against brute force; parameter within its range, gap along the normal, and
/// of a closed profile (body outside) negative just where it winds about the place.
/// @param tolerance  of distances, relative; at_centers: close to centers of curvature
inline void check_closest_points(const Profile<2>& profile, Random& random, int trials, double tolerance,
                                 double at_centers) {
  const Sampled samples(profile);
  const auto range = profile.range();
  const double L = range.end(0) - range.begin(0), size = samples.extent();
  for (int trial = 0; trial < trials; ++trial) {
    Vector<2> x =
        samples.low + (samples.high - samples.low)
                          .cwiseProduct(Vector<2>(random.between(-0.3, 1.3), random.between(-0.3, 1.3)));
    const auto at = profile.evaluate(Param<2>(range.begin(0) + L * random.between(0, 1)));
    if (trial % 3 == 1) x = at.x + size * random.decades(-12, -1) * (trial % 2 ? 1 : -1) * at.n; // near it
    if (trial % 3 == 2) { // where many points are almost equally near
      const double speed2 = at.x_s.squaredNorm(), k = at.n.dot(at.x_ss[0]) / speed2;
      if (std::abs(k) * size > 0.1) x = at.x + (1 + random.decades(-9, -1)) / k * at.n;
    }
    const double near = range.begin(0) + L * random.between(-3, 4);
    const auto foot = profile.closest_point(x, Param<2>(near));
    const auto there = profile.evaluate(foot.s);
    const double distance = (x - there.x).norm(), least = samples.distance(x);
    const double rounding = tolerance * (size + samples.high.norm() + samples.low.norm());
    ASSERT_LE(distance, least + (trial % 3 == 2 ? at_centers * distance : 0) + rounding)
        << "farther by " << distance - least << " at " << x.transpose();
    ASSERT_GE(distance, least - samples.spacing) << "at " << x.transpose();
    ASSERT_NEAR(std::abs(foot.gap), distance, rounding) << "at " << x.transpose();
    if (range.closed) {
      ASSERT_LE(std::abs(foot.s(0) - near), L / 2 * (1 + 1e-9));
      ASSERT_FALSE(foot.on_end);
      ASSERT_TRUE(least <= samples.spacing || (foot.gap < 0) == samples.around(x)) << "at " << x.transpose();
    } else {
      ASSERT_GE(foot.s(0), range.begin(0));
      ASSERT_LE(foot.s(0), range.end(0));
      if (foot.on_end) {
        ASSERT_GE(foot.gap, 0);
        ASSERT_TRUE(foot.s == range.begin || foot.s == range.end);
      } else {
        ASSERT_LE((there.x + foot.gap * there.n - x).norm(), 1e-3 * distance + rounding);
      }
    }
  }
}

} // namespace burnish::test
