#include "geometry/arc_piece.hpp"
#include "geometry/plane.hpp"
#include <algorithm>

namespace burnish {

Vector<2> ArcPiece::point(double s) const {
  if (curvature == 0) return start + s * tangent;
  const double angle = curvature * s, half = std::sin(angle / 2);
  return start + (std::sin(angle) * tangent + 2 * half * half * left_of(tangent)) / curvature;
}

Vector<2> ArcPiece::direction(double s) const {
  const double angle = curvature * s;
  return std::cos(angle) * tangent + std::sin(angle) * left_of(tangent);
}

ArcFoot ArcPiece::closest(const Vector<2>& x, double near) const {
  const double a = tangent.dot(x - start), b = left_of(tangent).dot(x - start);
  // relative to the center: k (x - center) = rho (sin(angle), -cos(angle))
  const double rho = std::hypot(curvature * a, 1 - curvature * b);
  ArcFoot foot;
  foot.s = a;
  if (rho < 1e-14) {
    foot.s = near;
  } else if (curvature != 0) {
    const double turn = std::abs(curvature) * length, sign = curvature > 0 ? 1 : -1;
    double angle = sign * std::atan2(curvature * a, 1 - curvature * b);
    if (angle < turn / 2 - M_PI) angle += 2 * M_PI; // opposite the middle of the arc
    foot.s = angle / std::abs(curvature);
  }
  foot.excess = std::max(-foot.s, foot.s - length);
  foot.s = std::clamp(foot.s, 0.0, length);
  // (1 - rho)/k without cancellation
  foot.offset = (2 * b - curvature * (a * a + b * b)) / (1 + rho);
  foot.distance = std::abs(foot.offset);
  if (foot.excess > 0) {
    const Vector<2> rest = x - point(foot.s);
    foot.distance = rest.norm();
    foot.offset = left_of(direction(foot.s)).dot(rest);
  }
  return foot;
}

namespace {

Vector<2> center_of(const ArcPiece& arc) { return arc.start + left_of(arc.tangent) / arc.curvature; }

// Where the endless line or whole circle of one meets that of the other.
std::vector<Vector<2>> meetings(const ArcPiece& a, const ArcPiece& b) {
  if (a.curvature == 0 && b.curvature == 0) {
    const double sine = cross(a.tangent, b.tangent);
    if (sine == 0) return {};
    return {a.start + cross(b.start - a.start, b.tangent) / sine * a.tangent};
  }
  if (a.curvature == 0) return meetings(b, a);
  const Vector<2> center = center_of(a);
  const double R = 1 / std::abs(a.curvature);
  Vector<2> middle, along; // of the common chord
  if (b.curvature == 0) {
    middle = b.start + b.tangent.dot(center - b.start) * b.tangent;
    along = b.tangent;
  } else {
    const Vector<2> apart = center_of(b) - center;
    const double d2 = apart.squaredNorm(), r = 1 / std::abs(b.curvature);
    if (d2 == 0) return {};
    middle = center + (d2 + R * R - r * r) / (2 * d2) * apart;
    along = left_of(apart).normalized();
  }
  const double half2 = R * R - (middle - center).squaredNorm(); // < 0: perhaps they touch, up to tolerance
  const Vector<2> half = std::sqrt(std::max(half2, 0.)) * along;
  return {middle - half, middle + half};
}

} // namespace

std::vector<Vector<2>> common_points(const ArcPiece& a, const ArcPiece& b, double tolerance) {
  std::vector<Vector<2>> points;
  const auto keep = [&](const Vector<2>& x) {
    if (a.closest(x, 0).distance <= tolerance && b.closest(x, 0).distance <= tolerance) points.push_back(x);
  };
  for (const ArcPiece* piece : {&a, &b})
    for (const double s : {0.0, piece->length}) keep(piece->point(s));
  for (const Vector<2>& x : meetings(a, b)) keep(x);
  return points;
}

} // namespace burnish
