#pragma once
// Polynomials in the plane by their Chebyshev coefficients on an interval.
#include "base/types.hpp"
#include <cmath>
#include <vector>

namespace burnish {

using Coefficients = std::vector<Vector<2>>;

/// The degree + 1 Chebyshev points of [begin, end].
inline std::vector<double> chebyshev_points(int degree, double begin, double end) {
  std::vector<double> u(static_cast<std::size_t>(degree) + 1);
  for (int j = 0; j <= degree; ++j) {
    const double t = std::cos(M_PI * (j + 0.5) / (degree + 1));
    u[static_cast<std::size_t>(j)] = (begin + end) / 2 + (end - begin) / 2 * t;
  }
  return u;
}

/// Coefficients of the polynomial through values at chebyshev_points, one column per point.
inline Coefficients chebyshev_fit(const Eigen::Matrix2Xd& values) {
  const Eigen::Index n = values.cols();
  Coefficients c(static_cast<std::size_t>(n), Vector<2>::Zero());
  for (Eigen::Index k = 0; k < n; ++k) {
    for (Eigen::Index j = 0; j < n; ++j)
      c[static_cast<std::size_t>(k)] +=
          std::cos(M_PI * static_cast<double>(k) * (static_cast<double>(j) + 0.5) / static_cast<double>(n)) *
          values.col(j);
    c[static_cast<std::size_t>(k)] *= (k == 0 ? 1.0 : 2.0) / static_cast<double>(n);
  }
  return c;
}

/// Of the derivative on an interval of that width.
inline Coefficients chebyshev_derivative(const Coefficients& c, double width) {
  const std::size_t n = c.size();
  Coefficients d(n > 1 ? n - 1 : 1, Vector<2>::Zero());
  for (std::size_t k = n; k-- > 1;) // d[k-1] = d[k+1] + 2 k c[k]
    d[k - 1] = (k + 1 < d.size() ? d[k + 1] : Vector<2>::Zero()) + 2.0 * static_cast<double>(k) * c[k];
  d[0] /= 2;
  for (auto& value : d) value *= 2 / width;
  return d;
}

/// Value at t in [-1, 1], the place in the interval (Clenshaw's recurrence).
inline Vector<2> chebyshev_value(const Coefficients& c, double t) {
  Vector<2> a = Vector<2>::Zero(), b = Vector<2>::Zero();
  for (std::size_t k = c.size(); k-- > 1;) {
    const Vector<2> next = c[k] + 2 * t * a - b;
    b = a;
    a = next;
  }
  return c[0] + t * a - b;
}

} // namespace burnish
