#include "cad/occ/corner_fillet.hpp"
#include "geometry/plane.hpp"
#include <Eigen/LU>
#include <cmath>

namespace burnish {

namespace {

constexpr int CORNER_ROUNDS = 40, CORNER_PLACES = 200;
constexpr int CORNER_STEPS = 16;        // of the radius, from 0 on
constexpr double CORNER_CLOSED = 1e-12; // of the lengths
constexpr double CORNER_CLOSER = 1e-6;  // of the radius: places between those that are looked at

struct Corner {
  const CadPiece &before, &after;
  double side; ///< +1: the corner turns to the left

  struct Offset {
    Vector<2> center, by_s; ///< of a circle that touches there, and its derivative
  };
  Offset offset(const CadPiece& curve, double s, double radius) const {
    const CadValue value = curve.at(s);
    const double speed = value.first.norm();
    const Vector<2> t = value.first / speed, turn = (value.second - t * t.dot(value.second)) / speed;
    return {value.x + side * radius * left_of(t), value.first + side * radius * left_of(turn)};
  }
  static bool keeps_away(const CadPiece& curve, const Vector<2>& center, double radius) {
    for (int i = 0; i <= CORNER_PLACES; ++i) {
      const Vector<2> x = curve.at(curve.length() * i / CORNER_PLACES).x;
      if ((x - center).norm() < (1 - CORNER_CLOSER) * radius) return false;
    }
    return true;
  }
  // Zero of the distance of both centers, by Newton's method from a and b.
  bool touches(double radius, double& a, double& b) const {
    for (int round = 0; round < CORNER_ROUNDS; ++round) {
      const Offset first = offset(before, a, radius), last = offset(after, b, radius);
      Tensor<2> slope;
      slope << first.by_s, -last.by_s;
      const Vector<2> way = slope.partialPivLu().solve(last.center - first.center);
      a += way[0];
      b += way[1];
      const double all = before.length() + after.length();
      if (!(way.norm() < all && std::abs(a) < 2 * all && std::abs(b) < 2 * all)) return false;
      if (way.norm() <= CORNER_CLOSED * all) return true;
    }
    return false;
  }
  bool fits(double radius) const {
    double a = before.length(), b = 0;
    for (int i = 1; i <= CORNER_STEPS; ++i)
      if (!touches(radius * i / CORNER_STEPS, a, b)) return false;
    const bool alone = before.tag() == after.tag();
    const Vector<2> center = offset(before, a, radius).center;
    return a >= 0 && a <= before.length() && b >= 0 && b <= after.length() && !(alone && a < b) &&
           keeps_away(before, center, radius) && keeps_away(after, center, radius);
  }
};

} // namespace

FilletRadii radii_that_fit(const CadPiece& before, const CadPiece& after) {
  const double side = left_of(before.end().first).dot(after.start().first) > 0 ? 1 : -1;
  const Corner corner{before, after, side};
  return radii_of(largest_radius(before.length() + after.length(), [&](double r) { return corner.fits(r); }));
}

} // namespace burnish
