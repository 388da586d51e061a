#pragma once
// Splines by their definition, in extended precision: what the curves of OpenCASCADE are compared with.
#include <array>
#include <cmath>
#include <vector>

namespace burnish::test {

using Real = long double;
using RealPoint = std::array<Real, 2>;
/// A value and its first three derivatives.
using Jet = std::array<RealPoint, 4>;

/// Poles with weights, and all knots, each as often as it is repeated.
class SplineReference {
public:
  SplineReference(int degree, std::vector<RealPoint> poles, std::vector<Real> weights,
                  std::vector<Real> knots)
      : m_degree(degree), m_knots(std::move(knots)) {
    for (std::size_t i = 0; i < poles.size(); ++i)
      m_poles.push_back({weights[i] * poles[i][0], weights[i] * poles[i][1], weights[i]});
  }

  /// Of the span [knots[k], knots[k + 1]), also beyond it.
  Jet at(Real u, std::size_t k) const {
    std::array<std::array<Real, 3>, 4> h{}; // homogeneous coordinates and their derivatives
    auto poles = m_poles;
    auto knots = m_knots;
    for (int order = 0; order <= 3 && order <= m_degree; ++order) {
      h[static_cast<std::size_t>(order)] =
          de_boor(poles, knots, m_degree - order, u, k - static_cast<std::size_t>(order));
      for (std::size_t i = 0; i + 1 < poles.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
          const Real width = knots[i + static_cast<std::size_t>(m_degree - order) + 1] - knots[i + 1];
          poles[i][c] = width > 0 ? (m_degree - order) * (poles[i + 1][c] - poles[i][c]) / width : 0;
        }
      poles.pop_back();
      knots.erase(knots.begin());
      knots.pop_back();
    }
    Jet x{};
    for (std::size_t c = 0; c < 2; ++c) { // Leibniz: (w x)' = w' x + w x', ...
      x[0][c] = h[0][c] / h[0][2];
      x[1][c] = (h[1][c] - h[1][2] * x[0][c]) / h[0][2];
      x[2][c] = (h[2][c] - 2 * h[1][2] * x[1][c] - h[2][2] * x[0][c]) / h[0][2];
      x[3][c] = (h[3][c] - 3 * h[1][2] * x[2][c] - 3 * h[2][2] * x[1][c] - h[3][2] * x[0][c]) / h[0][2];
    }
    return x;
  }

  Jet at(Real u) const {
    std::size_t k = static_cast<std::size_t>(m_degree);
    while (k + 2 + static_cast<std::size_t>(m_degree) < m_knots.size() && m_knots[k + 1] <= u) ++k;
    return at(u, k);
  }

private:
  using Homogeneous = std::array<Real, 3>;
  static Homogeneous de_boor(const std::vector<Homogeneous>& poles, const std::vector<Real>& t, int degree,
                             Real u, std::size_t k) {
    const auto p = static_cast<std::size_t>(degree);
    std::vector<Homogeneous> d;
    for (std::size_t j = 0; j <= p; ++j) d.push_back(poles[j + k - p]);
    for (std::size_t r = 1; r <= p; ++r)
      for (std::size_t j = p; j >= r; --j) {
        const Real a = (u - t[j + k - p]) / (t[j + 1 + k - r] - t[j + k - p]);
        for (std::size_t c = 0; c < 3; ++c) d[j][c] = (1 - a) * d[j - 1][c] + a * d[j][c];
      }
    return d[p];
  }

  int m_degree;
  std::vector<Homogeneous> m_poles;
  std::vector<Real> m_knots;
};

/// The curve at a distance to the right of another one, with two derivatives.
inline Jet beside(const Jet& c, Real distance) {
  using Series = std::array<Real, 3>; // Taylor coefficients
  const auto times = [](const Series& a, const Series& b) {
    return Series{a[0] * b[0], a[0] * b[1] + a[1] * b[0], a[0] * b[2] + a[1] * b[1] + a[2] * b[0]};
  };
  const Series tx{c[1][0], c[2][0], c[3][0] / 2}, ty{c[1][1], c[2][1], c[3][1] / 2};
  const Series xx = times(tx, tx), yy = times(ty, ty);
  const Series s{xx[0] + yy[0], xx[1] + yy[1], xx[2] + yy[2]};
  // 1/sqrt(s)
  const Real f = 1 / std::sqrt(s[0]), a = s[1] / s[0], b = s[2] / s[0];
  const Series inverse{f, -f * a / 2, f * (3 * a * a / 8 - b / 2)};
  const Series nx = times(ty, inverse), ny = times(tx, inverse);
  Jet x = c;
  const Real factor[] = {1, 1, 2};
  for (std::size_t k = 0; k < 3; ++k) {
    x[k][0] += distance * factor[k] * nx[k];
    x[k][1] -= distance * factor[k] * ny[k];
  }
  return x;
}

} // namespace burnish::test
