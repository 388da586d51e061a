#include "geometry/cad_knots.hpp"
#include <algorithm>

namespace burnish {

namespace {

constexpr double LEAST = 1e-7; // of the range: halved no further
constexpr double SMALL = 1e-2; // of a neighbor: an interval left over around a knot
constexpr std::size_t MOST = 2000;
constexpr int MOST_CUBICS = 2000;

std::vector<double> test_points(double begin, double end, int degree) {
  const int inner = degree < 4 ? 4 : 13;
  std::vector<double> u;
  for (int i = 1; i <= inner; ++i) u.push_back(begin + (end - begin) * i / (inner + 1));
  for (double near = 1e-2; near > 1e-7; near /= 10) {
    u.push_back(begin + near * (end - begin));
    u.push_back(end - near * (end - begin));
  }
  return u;
}

struct Interval {
  double begin, end;
  bool smooth;
  Coefficients c;
  double width() const { return end - begin; }
  Vector<2> at(double u) const { return chebyshev_value(c, (2 * u - begin - end) / width()); }
};

class KnotFinder {
public:
  KnotFinder(const CadSamples& samples, double begin, double end, double tolerance)
      : m_samples(samples), m_least(LEAST * (end - begin)), m_tolerance(tolerance) {
    split(begin, end);
  }
  bool too_many() const { return m_intervals.size() > MOST; }
  std::vector<double> knots(double& jump) const;

private:
  Interval make(double begin, double end) const {
    Interval interval{begin, end, false, {}};
    interval.smooth = cad_misfit(m_samples, CAD_DEGREE, begin, end, interval.c) <= m_tolerance;
    return interval;
  }
  void split(double begin, double end);
  std::vector<std::size_t> large() const;
  double meeting(const Interval& a, const Interval& b) const;

  const CadSamples& m_samples;
  double m_least, m_tolerance;
  std::vector<Interval> m_intervals;
};

void KnotFinder::split(double begin, double end) {
  if (too_many()) return;
  Interval interval = make(begin, end);
  if (!interval.smooth && end - begin > m_least) {
    split(begin, (begin + end) / 2);
    return split((begin + end) / 2, end);
  }
  if (interval.smooth && !m_intervals.empty() && m_intervals.back().smooth) {
    Interval both = make(m_intervals.back().begin, end);
    if (both.smooth) return m_intervals.back() = both, void();
  }
  m_intervals.push_back(interval);
}

// All but the ones left over around knots.
std::vector<std::size_t> KnotFinder::large() const {
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < m_intervals.size(); ++i) {
    double neighbor = 0;
    if (i > 0) neighbor = m_intervals[i - 1].width();
    if (i + 1 < m_intervals.size()) neighbor = std::max(neighbor, m_intervals[i + 1].width());
    if (m_intervals[i].smooth && m_intervals[i].width() >= SMALL * neighbor) list.push_back(i);
  }
  return list;
}

// Where two neighboring polynomials are equal, between them or nearly so; NaN if they are not.
double KnotFinder::meeting(const Interval& a, const Interval& b) const {
  const auto apart = [&](double u) { return (a.at(u) - b.at(u)).norm(); };
  double low = a.end - 1e-3 * a.width(), high = b.begin + 1e-3 * b.width(), best = a.end;
  for (int round = 0; round < 12; ++round) { // of 33 places the best, then around it
    const double step = (high - low) / 32;
    double least = apart(best);
    for (int i = 0; i <= 32; ++i) {
      const double u = low + i * step;
      if (apart(u) >= least) continue;
      least = apart(u);
      best = u;
    }
    low = best - step;
    high = best + step;
  }
  return apart(best) <= 10 * m_tolerance ? best : std::nan("");
}

std::vector<double> KnotFinder::knots(double& jump) const {
  const auto list = large();
  std::vector<double> knots{m_intervals.front().begin};
  for (std::size_t k = 0; k + 1 < list.size(); ++k) {
    const Interval &a = m_intervals[list[k]], &b = m_intervals[list[k + 1]];
    double knot = meeting(a, b);
    if (std::isnan(knot)) { // no: what lies between are spans of their own
      for (std::size_t i = list[k] + 1; i <= list[k + 1]; ++i) {
        if (!m_intervals[i].smooth) return jump = m_intervals[i].begin, std::vector<double>();
        knots.push_back(m_intervals[i].begin);
      }
    } else {
      knots.push_back(knot);
    }
  }
  knots.push_back(m_intervals.back().end);
  return knots;
}

} // namespace

double cad_misfit(const CadSamples& samples, int degree, double begin, double end, Coefficients& c) {
  c = chebyshev_fit(samples(chebyshev_points(degree, begin, end)));
  const auto u = test_points(begin, end, degree);
  const Eigen::Matrix2Xd expected = samples(u);
  double error = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    const double t = (2 * u[i] - begin - end) / (end - begin);
    error = std::max(error, (chebyshev_value(c, t) - expected.col(static_cast<Eigen::Index>(i))).norm());
  }
  return error;
}

std::vector<double> find_knots(const CadSamples& derivative, double begin, double end, double tolerance,
                               double& jump) {
  jump = std::nan("");
  const KnotFinder finder(derivative, begin, end, tolerance);
  if (finder.too_many()) return {};
  return finder.knots(jump);
}

std::vector<double> equal_cubics(const CadSamples& value, double begin, double end, double tolerance) {
  for (int m = 1; m <= MOST_CUBICS; ++m) {
    std::vector<double> knots;
    for (int i = 0; i <= m; ++i) knots.push_back(begin + (end - begin) * i / m);
    Coefficients c;
    std::size_t i = 0;
    while (i + 1 < knots.size() && cad_misfit(value, 3, knots[i], knots[i + 1], c) <= tolerance) ++i;
    if (i + 1 == knots.size()) return knots;
  }
  return {};
}

} // namespace burnish
