#pragma once
// A point of a curved surface that a rigid motion moves, with its frame there, on it and after the motion.
#include "kinematics/tool.hpp"
#include "unit/finite_difference.hpp"
#include <random>

namespace burnish::test {

/// A rotation by any angle about any axis.
template <int Dim> Tensor<Dim> any_rotation(unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  if constexpr (Dim == 2) {
    return Eigen::Rotation2Dd(normal(random)).toRotationMatrix();
  } else {
    const Eigen::Vector4d axis = Eigen::Vector4d::NullaryExpr([&] { return normal(random); });
    return Eigen::Quaterniond(axis.normalized()).toRotationMatrix();
  }
}

/// The graph z = c' B c/2 - cubic over the tangent plane at a point, turned by `base`; its normal falls away from z, so
/// that dn = E B d(eta). Coordinates q: a rotation by an angle about a fixed axis, and an offset along it.
template <int Dim> class SurfaceSample {
public:
  explicit SurfaceSample(unsigned seed) : m_base(any_rotation<Dim>(seed)) {
    std::mt19937 random(seed + 1);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const Curvature<Dim> A = Curvature<Dim>::NullaryExpr([&] { return uniform(random); });
    m_B = A + A.transpose();
    m_cubic = Param<Dim>::NullaryExpr([&] { return uniform(random); });
    m_spin.setZero();
    for (int i = 0; i < Dim; ++i)
      for (int j = 0; j < i; ++j) {
        m_spin(i, j) = uniform(random);
        m_spin(j, i) = -m_spin(i, j);
      }
  }
  /// Normal at the place `c` of the tangent plane, after the motion by the angle.
  Vector<Dim> normal(const Param<Dim>& c, double angle) const {
    const Param<Dim> rise = -(m_B * c) + m_cubic * c.squaredNorm();
    Vector<Dim> n;
    n << -rise, 1;
    return rotation(angle) * m_base * n.normalized();
  }
  /// Orthonormal tangents there: those at c = 0, projected and orthonormalized.
  Tangents<Dim> tangents(const Param<Dim>& c, double angle) const {
    const Vector<Dim> n = normal(c, angle);
    const Tangents<Dim> start = rotation(angle) * m_base.template leftCols<Dim - 1>();
    Tangents<Dim> E = start - n * (n.transpose() * start);
    for (int a = 0; a < Dim - 1; ++a) {
      for (int b = 0; b < a; ++b) E.col(a) -= E.col(b).dot(E.col(a)) * E.col(b);
      E.col(a).normalize();
    }
    return E;
  }
  /// Rotation of the tool; its derivative at zero is the spin.
  Tensor<Dim> rotation(double angle) const {
    const Tensor<Dim> half = 0.5 * angle * m_spin, one = Tensor<Dim>::Identity();
    return (one - half).inverse() * (one + half); // Cayley
  }
  /// The point at c = 0 with its derivatives.
  SurfacePoint<Dim> point() const {
    SurfacePoint<Dim> p;
    p.x.setZero();
    p.n = normal(Param<Dim>::Zero(), 0);
    p.E = tangents(Param<Dim>::Zero(), 0);
    p.B = m_B;
    p.x_q = PerCoordinate<Dim>::Zero(Dim, 2);
    p.x_q.col(1) = p.E.col(0);
    p.n_q = PerCoordinate<Dim>::Zero(Dim, 2);
    p.n_q.col(0) = m_spin * p.n;
    for (int a = 0; a < Dim - 1; ++a) {
      p.E_q[a] = PerCoordinate<Dim>::Zero(Dim, 2);
      p.E_q[a].col(0) = m_spin * p.E.col(a);
    }
    return p;
  }

private:
  Tensor<Dim> m_base, m_spin;
  Curvature<Dim> m_B;
  Param<Dim> m_cubic;
};

/// The same point seen in tangents turned by Q: E Q.
template <int Dim> SurfacePoint<Dim> turned(const SurfacePoint<Dim>& p, const Curvature<Dim>& Q) {
  SurfacePoint<Dim> other = p;
  other.E = p.E * Q;
  other.B = Q.transpose() * p.B * Q;
  for (int a = 0; a < Dim - 1; ++a) {
    other.E_q[a].setZero();
    for (int b = 0; b < Dim - 1; ++b) other.E_q[a] += Q(b, a) * p.E_q[b];
  }
  return other;
}

} // namespace burnish::test
