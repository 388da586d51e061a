#include "geometry/bezier_span.hpp"
#include <algorithm>

namespace burnish {

namespace {

using Poles = std::vector<Eigen::Vector4d>;

constexpr std::size_t MOST_POLES = 26; // OpenCASCADE has splines up to degree 25

// Of the span that begins at knots[at]: de Boor's algorithm with an argument of its own on each level.
Eigen::Vector4d blossom(Poles d, const std::vector<double>& knots, std::size_t at,
                        const std::vector<double>& arguments) {
  const std::size_t p = arguments.size();
  for (std::size_t r = 1; r <= p; ++r)
    for (std::size_t j = p; j >= r; --j) {
      const double left = knots[j + at - p], right = knots[j + 1 + at - r];
      const double part = (arguments[r - 1] - left) / (right - left);
      d[j] = (1 - part) * d[j - 1] + part * d[j];
    }
  return d[p];
}

Poles bezier_poles(const Poles& d, const std::vector<double>& knots, std::size_t at) {
  const std::size_t p = d.size() - 1;
  std::vector<double> arguments(p, knots[at]);
  Poles poles{blossom(d, knots, at, arguments)};
  for (std::size_t j = 1; j <= p; ++j) { // pole j: j times the end, p - j times the begin
    arguments[p - j] = knots[at + 1];
    poles.push_back(blossom(d, knots, at, arguments));
  }
  return poles;
}

// Poles that count in the span of the derivative.
Poles derivative(const Poles& d, const std::vector<double>& knots, std::size_t at) {
  const std::size_t p = d.size() - 1;
  Poles poles;
  for (std::size_t j = 0; j < p; ++j)
    poles.push_back(static_cast<double>(p) / (knots[at + 1 + j] - knots[at + 1 + j - p]) * (d[j + 1] - d[j]));
  if (p == 0) poles.push_back(Eigen::Vector4d::Zero());
  return poles;
}

Eigen::Vector4d de_casteljau(const Poles& poles, double t) {
  std::array<Eigen::Vector4d, MOST_POLES> q;
  std::copy(poles.begin(), poles.end(), q.begin());
  for (std::size_t left = poles.size() - 1; left > 0; --left)
    for (std::size_t i = 0; i < left; ++i) q[i] = (1 - t) * q[i] + t * q[i + 1];
  return q[0];
}

} // namespace

BezierSpan::BezierSpan(const std::vector<Vector<3>>& poles, const std::vector<double>& weights,
                       const std::vector<double>& knots, std::size_t at, double shift)
    : m_begin(knots[at] + shift), m_width(knots[at + 1] - knots[at]) {
  const std::size_t p = knots.size() - poles.size() - 1;
  m_origin = poles[at - p]; // far from zero less would be left of the differences
  Poles d;
  for (std::size_t i = at - p; i <= at; ++i) {
    d.emplace_back(0, 0, 0, weights[i]);
    d.back().head<3>() = weights[i] * (poles[i] - m_origin);
  }
  m_rational = std::any_of(d.begin(), d.end(), [](const Eigen::Vector4d& h) { return h.w() != 1; });
  for (Poles& result : m_poles) {
    result = bezier_poles(d, knots, at);
    d = derivative(d, knots, at);
  }
}

CurveValue BezierSpan::at(double u) const {
  const double t = (u - m_begin) / m_width;
  const Eigen::Vector4d h = de_casteljau(m_poles[0], t), first = de_casteljau(m_poles[1], t),
                        second = de_casteljau(m_poles[2], t);
  if (!m_rational) return {m_origin + h.head<3>(), first.head<3>(), second.head<3>()};
  CurveValue value; // (w x)' = w' x + w x', (w x)'' = w'' x + 2 w' x' + w x''
  const Vector<3> x = h.head<3>() / h.w();
  value.x = m_origin + x;
  value.first = (first.head<3>() - first.w() * x) / h.w();
  value.second = (second.head<3>() - second.w() * x - 2 * first.w() * value.first) / h.w();
  return value;
}

} // namespace burnish
