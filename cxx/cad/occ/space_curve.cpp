#include "cad/occ/space_curve.hpp"
#include <algorithm>
#include <cmath>

namespace burnish {

namespace {

constexpr double PART_TURN = 0.15; // rad between the ends of a part
constexpr int MOST_PART_HALVINGS = 10, PART_SAMPLES = 4;
constexpr double SAG_MARGIN = 1.5; // what samples tell of the rest

double from_chord(const Vector<3>& a, const Vector<3>& b, const Vector<3>& x) {
  const Vector<3> chord = b - a;
  const double length2 = chord.squaredNorm();
  const double f = length2 > 0 ? std::clamp((x - a).dot(chord) / length2, 0., 1.) : 0;
  return (x - a - f * chord).norm();
}

} // namespace

SpaceCurve::SpaceCurve(ExactCurve curve) : m_curve(std::move(curve)) {
  const auto& knots = m_curve.knots();
  m_u.push_back(knots.front());
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) add(knots[i], knots[i + 1], 0);
}

void SpaceCurve::add(double begin, double end, int depth) {
  Vector<3> x[PART_SAMPLES + 1], t[PART_SAMPLES + 1];
  double turn = 0, sag = 0;
  for (int k = 0; k <= PART_SAMPLES; ++k) {
    const CurveValue value = m_curve.evaluate(begin + (end - begin) * k / PART_SAMPLES, k == PART_SAMPLES);
    x[k] = value.x;
    t[k] = value.first;
    if (k > 0) turn += std::atan2(t[k - 1].cross(t[k]).norm(), t[k - 1].dot(t[k]));
  }
  if (turn > PART_TURN && depth < MOST_PART_HALVINGS) {
    add(begin, (begin + end) / 2, depth + 1);
    return add((begin + end) / 2, end, depth + 1);
  }
  for (int k = 1; k < PART_SAMPLES; ++k) sag = std::max(sag, from_chord(x[0], x[PART_SAMPLES], x[k]));
  m_u.push_back(end);
  m_sag.push_back(SAG_MARGIN * sag + 1e-14 * x[0].norm());
}

Eigen::AlignedBox3d SpaceCurve::box(int part) const {
  const auto i = static_cast<std::size_t>(part);
  Eigen::AlignedBox3d box(at(m_u[i]).x);
  box.extend(at(m_u[i + 1]).x);
  const Vector<3> more = Vector<3>::Constant(m_sag[i]);
  return {box.min() - more, box.max() + more};
}

// Zero of x_u . (x - p) by Newton within a bracket, or the nearer end.
SpaceCurve::Nearest SpaceCurve::nearest(int part, const Vector<3>& p) const {
  double low = m_u[static_cast<std::size_t>(part)], high = m_u[static_cast<std::size_t>(part) + 1];
  const double range = high - low;
  const auto seen = [&](double u) {
    const Vector<3> x = at(u).x;
    return Nearest{u, x, (x - p).norm()};
  };
  const Nearest first = seen(low), last = seen(high);
  Nearest best = first.distance <= last.distance ? first : last;
  const double f_low = at(low).first.dot(first.x - p),
               f_high = m_curve.evaluate(high, true).first.dot(last.x - p);
  if (f_low >= 0 || f_high <= 0) return best;
  double u = low + range * f_low / (f_low - f_high);
  for (int round = 0; round < 60; ++round) {
    const CurveValue value = at(u);
    const double f = value.first.dot(value.x - p),
                 slope = value.first.squaredNorm() + value.second.dot(value.x - p);
    (f < 0 ? low : high) = u;
    const double newton = slope > 0 ? u - f / slope : high + 1;
    const bool done = std::abs(newton - u) <= 1e-15 * range;
    u = newton > low && newton < high ? newton : done ? u : (low + high) / 2;
    if (done || high - low <= 1e-15 * range) break;
  }
  const Nearest foot = seen(u);
  return foot.distance <= best.distance ? foot : best;
}

double SpaceCurve::parameter(double f) const {
  const double place = std::clamp(f, 0., 1.) * parts();
  const auto i = std::min(static_cast<std::size_t>(place), m_u.size() - 2);
  return m_u[i] + (place - static_cast<double>(i)) * (m_u[i + 1] - m_u[i]);
}

double SpaceCurve::length() const {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < m_u.size(); ++i) sum += (at(m_u[i + 1]).x - at(m_u[i]).x).norm();
  return sum;
}

} // namespace burnish
