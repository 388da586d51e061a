#include "kinematics/rotation.hpp"
#include "formula/formula.hpp"
#include "geometry/plane.hpp"
#include <array>

namespace burnish {
namespace {

template <int Dim> RotationValue<Dim> blank_rotation(int size) {
  RotationValue<Dim> value;
  value.R.setIdentity();
  value.first.assign(static_cast<std::size_t>(size), Tensor<Dim>::Zero());
  value.second.assign(static_cast<std::size_t>(size), value.first);
  return value;
}

/// A function of t = |vector|^2 with its first and second derivative.
struct OfSquare {
  double value, first, second;
};

// sum of (-t)^n/(2 n + m)!: for m = 1 sin(p)/p, for m = 2 (1 - cos(p))/p^2, p^2 = t <= 1; to rounding
OfSquare series(double t, int m) {
  constexpr int terms = 11;
  OfSquare sum{0, 0, 0};
  double factor = m == 1 ? 1 : 0.5, power = 1, lower = 0,
         lowest = 0; // (-1)^n/(2 n + m)!; t^n, t^(n-1), t^(n-2)
  for (int n = 0; n < terms; ++n) {
    sum.value += factor * power;
    sum.first += factor * n * lower;
    sum.second += factor * n * (n - 1) * lowest;
    lowest = lower;
    lower = power;
    power *= t;
    factor /= -(2. * n + m + 1) * (2. * n + m + 2);
  }
  return sum;
}

/// sin(p)/p and (1 - cos(p))/p^2.
std::array<OfSquare, 2> rodrigues(double t) {
  if (t < 1) return {series(t, 1), series(t, 2)};
  const double p = std::sqrt(t), cosine = std::cos(p);
  OfSquare a{std::sin(p) / p, 0, 0}, b{(1 - cosine) / t, 0, 0};
  a.first = (cosine - a.value) / (2 * t);
  b.first = (a.value - 2 * b.value) / (2 * t);
  a.second = -(a.value / 4 + 1.5 * a.first) / t;
  b.second = (a.first / 2 - 2 * b.first) / t;
  return {a, b};
}

} // namespace

RotationValue<2> AngleRotation::at(const Eigen::VectorXd& a) const {
  const Tensor<2> R = plane_rotation(a[0]);
  return {R, {plane_rotation_derivative(R)}, {{-R}}};
}

AxisRotations::AxisRotations(const std::vector<Vector<3>>& axes) {
  for (const auto& axis : axes) m_spins.push_back(cross_matrix(axis.normalized()));
}

RotationValue<3> AxisRotations::at(const Eigen::VectorXd& a) const {
  std::vector<std::array<Tensor<3>, 3>> factors; // with derivatives by their angles
  for (std::size_t i = 0; i < m_spins.size(); ++i) {
    const double angle = a[static_cast<Eigen::Index>(i)], half = std::sin(angle / 2);
    const Tensor<3>& H = m_spins[i];
    const Tensor<3> factor = Tensor<3>::Identity() + std::sin(angle) * H + 2 * half * half * (H * H);
    factors.push_back({factor, H * factor, H * H * factor});
  }
  const auto product = [&](std::size_t i, std::size_t j) { // derivative by i and j; size(): by none
    Tensor<3> R = Tensor<3>::Identity();
    for (std::size_t k = 0; k < factors.size(); ++k) R = R * factors[k][(k == i) + (k == j)];
    return R;
  };
  const std::size_t none = factors.size();
  RotationValue<3> value = blank_rotation<3>(size());
  value.R = product(none, none);
  for (std::size_t i = 0; i < none; ++i) {
    value.first[i] = product(i, none);
    for (std::size_t j = 0; j < none; ++j) value.second[i][j] = product(std::min(i, j), std::max(i, j));
  }
  return value;
}

RotationValue<3> VectorRotation::at(const Eigen::VectorXd& a) const {
  const Vector<3> v = a;
  const auto [s, c] = rodrigues(v.squaredNorm());
  const Tensor<3> H = cross_matrix(v), HH = H * H;
  std::array<Tensor<3>, 3> L, H2_i; // dH/dv_i, d(H H)/dv_i
  for (int i = 0; i < 3; ++i) {
    L[i] = cross_matrix(Vector<3>::Unit(i));
    H2_i[i] = L[i] * H + H * L[i];
  }
  RotationValue<3> value = blank_rotation<3>(3);
  value.R += s.value * H + c.value * HH;
  for (int i = 0; i < 3; ++i) {
    const double s_i = 2 * v[i] * s.first, c_i = 2 * v[i] * c.first;
    value.first[i] = s_i * H + s.value * L[i] + c_i * HH + c.value * H2_i[i];
    for (int j = 0; j < 3; ++j) {
      const double s_j = 2 * v[j] * s.first, c_j = 2 * v[j] * c.first;
      const double s_ij = 2 * (i == j) * s.first + 4 * v[i] * v[j] * s.second;
      const double c_ij = 2 * (i == j) * c.first + 4 * v[i] * v[j] * c.second;
      value.second[i][j] = s_ij * H + s_i * L[j] + s_j * L[i] + c_ij * HH + c_i * H2_i[j] + c_j * H2_i[i] +
                           c.value * (L[i] * L[j] + L[j] * L[i]);
    }
  }
  return value;
}

RotationValue<3> QuaternionRotation::at(const Eigen::VectorXd& a) const {
  const Vector<4> Q = a;
  const double square = Q.squaredNorm();
  if (!std::isnormal(square)) // zero, underflow
    throw FormulaDomainError(m_where + ": the quaternion has the length 0, expected a direction; place " +
                             "its first number at 1 for no rotation");
  // N = |Q|^2 R is quadratic: its second derivatives are constant
  std::array<std::array<Tensor<3>, 4>, 4> N_kl;
  N_kl[0][0] = 2 * Tensor<3>::Identity();
  for (int i = 0; i < 3; ++i) {
    N_kl[0][i + 1] = N_kl[i + 1][0] = 2 * cross_matrix(Vector<3>::Unit(i));
    for (int j = 0; j < 3; ++j) {
      const Tensor<3> dyad = Vector<3>::Unit(i) * Vector<3>::Unit(j).transpose();
      N_kl[i + 1][j + 1] = 2 * (dyad + dyad.transpose() - (i == j) * Tensor<3>::Identity());
    }
  }
  RotationValue<3> value = blank_rotation<3>(4);
  for (int k = 0; k < 4; ++k)
    for (int l = 0; l < 4; ++l) value.first[k] += Q[l] * N_kl[k][l]; // dN/dQ_k
  value.R.setZero();
  for (int k = 0; k < 4; ++k) value.R += Q[k] / (2 * square) * value.first[k];
  for (int k = 0; k < 4; ++k) value.first[k] = (value.first[k] - 2 * Q[k] * value.R) / square;
  for (int k = 0; k < 4; ++k)
    for (int l = 0; l < 4; ++l)
      value.second[k][l] =
          (N_kl[k][l] - 2 * (k == l) * value.R - 2 * Q[k] * value.first[l] - 2 * Q[l] * value.first[k]) /
          square;
  return value;
}

} // namespace burnish
