#include "geometry/cad_spans.hpp"
#include "base/error.hpp"
#include "geometry/plane.hpp"
#include <algorithm>

namespace burnish {

namespace {

constexpr double EXACT = 1e-13; // relative: rounding
constexpr double LOOSEST = 1.1e-11;

double largest(const Eigen::Matrix2Xd& columns) {
  return std::sqrt(columns.colwise().squaredNorm().maxCoeff());
}

std::string place(const CadSource& source, double u) {
  const Eigen::Matrix2Xd x = source.value({u});
  std::ostringstream text;
  text << "(" << x(0, 0) << ", " << x(1, 0) << ")";
  return text.str();
}

void check_corner(const CadSource& source, double u, const Vector<2>& before, const Vector<2>& after) {
  const double angle = std::abs(std::atan2(left_of(before).dot(after), before.dot(after)));
  if (angle <= 1e-3) return;
  std::ostringstream text;
  text << source.name << " has a corner of " << angle * 180 / M_PI << " degrees at " << place(source, u)
       << "; round it with a fillet in the CAD system";
  fail("CadCurve", text.str());
}

} // namespace

CadSpans::CadSpans(const CadSource& source) {
  std::vector<double> u;
  for (int i = 0; i <= 200; ++i) u.push_back(source.begin + (source.end - source.begin) * i / 200);
  const Eigen::Matrix2Xd x = source.value(u);
  m_size = largest(x);
  const double extent = largest(x.colwise() - x.col(0));
  if (!(extent > 1e-12 * m_size))
    fail("CadCurve", source.name + " has no length: all its points are at " + place(source, u[0]));
  const double speed = source.derivative ? largest(source.derivative(u)) * std::max(1., m_size / extent) : 0;
  double jump = std::nan("");
  m_rounding = EXACT;
  while (!recover(source, speed, jump)) {
    m_rounding *= 10;
    if (!source.derivative || m_rounding > LOOSEST) refuse(source, jump);
  }
  for (std::size_t i = 1; i + 1 < m_knots.size(); ++i)
    check_corner(source, m_knots[i], evaluate(m_knots[i], true).first, evaluate(m_knots[i]).first);
}

// speed: largest |x_u|, enlarged for curves far from the origin. jump: as find_knots
bool CadSpans::recover(const CadSource& source, double speed, double& jump) {
  m_noise = m_rounding * speed;
  m_spans.clear();
  m_knots = {source.begin};
  const auto knots = source.derivative
                         ? find_knots(source.derivative, source.begin, source.end, m_noise, jump)
                         : knots_of_value(source);
  bool covered = !knots.empty();
  for (std::size_t i = 0; covered && i + 1 < knots.size(); ++i)
    covered = cover(source, knots[i], knots[i + 1], 0);
  return covered;
}

void CadSpans::refuse(const CadSource& source, double jump) const {
  if (std::isnan(jump))
    fail("CadCurve",
         "the second derivatives of " + source.name + " near " + place(source, m_knots.back()) +
             " cannot be recovered from what gmsh gives; draw it with another kind of curve, or use "
             "SetFactory(\"OpenCASCADE\") in the .geo file");
  const double aside = 1e-6 * (source.end - source.begin);
  const Eigen::Matrix2Xd t = source.derivative({jump - aside, jump + aside});
  check_corner(source, jump, t.col(0), t.col(1));
  fail("CadCurve", source.name + " changes its speed suddenly at " + place(source, jump) +
                       "; split it there in the CAD system");
}

// gmsh's own kernel: an arc is smooth, everything else consists of equal cubics.
std::vector<double> CadSpans::knots_of_value(const CadSource& source) const {
  Coefficients c;
  if (cad_misfit(source.value, CAD_DEGREE, source.begin, source.end, c) > EXACT * m_size) {
    const auto knots = equal_cubics(source.value, source.begin, source.end, EXACT * m_size);
    if (!knots.empty()) return knots;
  }
  return {source.begin, source.end};
}

bool CadSpans::fit(const CadSource& source, double begin, double end, Span& span) const {
  for (const int degree : {1, 2, 3, 5, 8, 12, CAD_DEGREE}) {
    if (cad_misfit(source.value, degree, begin, end, span.x) > 2 * m_rounding * m_size) continue;
    span.begin = begin;
    span.end = end;
    span.first = chebyshev_derivative(span.x, end - begin);
    if (source.derivative && cad_misfit(source.derivative, degree - 1, begin, end, span.first) > 2 * m_noise)
      continue;
    span.second = chebyshev_derivative(span.first, end - begin);
    return true;
  }
  return false;
}

// Spans that are no polynomials are halved until one of high degree is as good.
bool CadSpans::cover(const CadSource& source, double begin, double end, int depth) {
  Span span;
  if (fit(source, begin, end, span)) {
    m_spans.push_back(span);
    m_knots.push_back(end);
    return true;
  }
  const double middle = (begin + end) / 2;
  return depth < 6 && cover(source, begin, middle, depth + 1) && cover(source, middle, end, depth + 1);
}

CadValue CadSpans::evaluate(double u, bool before) const {
  const auto inner = m_knots.begin() + 1, last = m_knots.end() - 1;
  const auto place = before ? std::lower_bound(inner, last, u) : std::upper_bound(inner, last, u);
  const Span& span = m_spans[static_cast<std::size_t>(place - inner)];
  const double t = (2 * u - span.begin - span.end) / (span.end - span.begin);
  return {chebyshev_value(span.x, t), chebyshev_value(span.first, t), chebyshev_value(span.second, t)};
}

} // namespace burnish
