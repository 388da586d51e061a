#include "cad/occ/cad_piece.hpp"
#include <algorithm>
#include <sstream>
#include <utility>

namespace burnish {

namespace {

// Three-point Gauss rule on n parts of each span.
double arc_length(const ExactCurve& curve, int n) {
  const auto& knots = curve.knots();
  const double place = std::sqrt(0.6);
  double sum = 0;
  for (std::size_t i = 0; i + 1 < knots.size(); ++i)
    for (int k = 0; k < n; ++k) {
      const double half = (knots[i + 1] - knots[i]) / (2 * n), middle = knots[i] + (2 * k + 1) * half;
      const auto speed = [&](double t) { return curve.evaluate(middle + t * half).first.norm(); };
      sum += half * (5 * speed(-place) + 8 * speed(0) + 5 * speed(place)) / 9;
    }
  return sum;
}

double arc_length(const ExactCurve& curve) {
  double before = arc_length(curve, 4);
  for (int n = 8;; n *= 2) {
    const double length = arc_length(curve, n);
    if (std::abs(length - before) <= 1e-14 * length || n >= 512) return length;
    before = length;
  }
}

} // namespace

CadPiece::CadPiece(int tag, ExactCurve curve, double scale)
    : m_tag(tag), m_curve(std::move(curve)), m_scale(scale), m_begin(m_curve.knots().front()),
      m_length(scale * arc_length(m_curve)) {
  m_rate = (m_curve.knots().back() - m_begin) / m_length;
}

CadValue CadPiece::at(double s) const {
  const double rate = m_reversed ? -m_rate : m_rate;
  const auto value = m_curve.evaluate(parameter(s));
  return {m_scale * value.x.head<2>(), m_scale * rate * value.first.head<2>(),
          m_scale * rate * rate * value.second.head<2>()};
}

std::vector<double> CadPiece::knots() const {
  std::vector<double> s;
  for (const double u : m_curve.knots()) s.push_back((u - m_begin) / m_rate);
  s.back() = m_length;
  if (!m_reversed) return s;
  for (double& value : s) value = m_length - value;
  std::reverse(s.begin(), s.end());
  return s;
}

std::string place_text(const Vector<2>& x, double size) {
  const Vector<2> clean = (x.array().abs() < 1e-12 * size).select(0., x.array()).matrix();
  std::ostringstream text;
  text << "(" << clean.x() << ", " << clean.y() << ")";
  return text.str();
}

} // namespace burnish
